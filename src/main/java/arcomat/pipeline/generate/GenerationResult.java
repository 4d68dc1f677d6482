package arcomat.pipeline.generate;

import arcomat.pipeline.check.CheckResult;

import java.util.List;

/**
 * What came of generating code.
 *
 * @param check findings about models and templates; with errors nothing is written
 * @param files paths of the files that were written, below the output folder
 * @param robots programs for the brick among them, if the target makes such
 * @param watches what these watch themselves for
 */
public record GenerationResult(
        CheckResult check, List<String> files, List<Robot> robots, List<RobotWatch> watches) {
    public GenerationResult {
        files = List.copyOf(files);
        robots = List.copyOf(robots);
        watches = List.copyOf(watches);
    }
}
