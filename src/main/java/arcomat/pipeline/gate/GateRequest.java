package arcomat.pipeline.gate;

import arcomat.pipeline.analysis.AnalysisLimits;

import java.util.List;

/**
 * Whether components still keep what they promised.
 *
 * @param base the folders with the models as they were: model roots, one at least
 * @param paths the models as they are, of the same model roots
 * @param limits of each single comparison
 */
public record GateRequest(List<String> base, List<String> paths, AnalysisLimits limits) {
    public GateRequest {
        base = List.copyOf(base);
        paths = List.copyOf(paths);
    }
}
