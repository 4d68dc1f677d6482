package arcomat.pipeline.diagram;

import arcomat.pipeline.check.CheckResult;

import java.util.List;

/**
 * What came of a wish for pictures.
 *
 * @param check with errors, nothing was written
 * @param files paths in the output folder
 */
public record DiagramResult(CheckResult check, List<String> files) {
    public DiagramResult {
        files = List.copyOf(files);
    }
}
