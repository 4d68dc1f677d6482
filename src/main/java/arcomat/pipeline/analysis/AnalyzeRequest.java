package arcomat.pipeline.analysis;

import java.util.List;

/**
 * Which automata to examine.
 *
 * @param components as written, {@code p.Robot}, {@code p.Timer(2)} or {@code p.Robot#waits}; all
 *     that are named by path if empty
 */
public record AnalyzeRequest(List<String> components, AnalysisLimits limits) {
    public AnalyzeRequest {
        components = List.copyOf(components);
    }
}
