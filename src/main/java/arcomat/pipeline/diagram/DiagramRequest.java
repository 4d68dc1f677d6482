package arcomat.pipeline.diagram;

import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.picture.PictureFormat;

import java.util.List;
import java.util.Optional;

/**
 * Pictures that are asked for.
 *
 * @param components qualified names; empty for all components and class diagrams that the paths
 *     name
 * @param out the folder to be written, as a whole
 * @param depth how many levels of parts are shown inside a component
 * @param highlight how long to look for findings about automata, which are then marked; empty for
 *     plain pictures
 */
public record DiagramRequest(
        List<String> components,
        PictureFormat format,
        String out,
        int depth,
        Optional<AnalysisLimits> highlight) {
    public DiagramRequest {
        components = List.copyOf(components);
    }
}
