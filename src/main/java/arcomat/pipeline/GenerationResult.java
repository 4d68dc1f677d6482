package arcomat.pipeline;

import java.util.List;

/**
 * What came of generating code.
 *
 * @param check findings about models and templates; with errors nothing is written
 * @param files paths of the files that were written, below the output folder
 */
public record GenerationResult(CheckResult check, List<String> files) {
    public GenerationResult {
        files = List.copyOf(files);
    }
}
