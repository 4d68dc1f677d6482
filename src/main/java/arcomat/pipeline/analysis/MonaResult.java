package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Answered;
import arcomat.pipeline.check.CheckResult;

import java.util.Optional;

/**
 * What became of a question for the program MONA.
 *
 * @param settled the answer where the program need not or cannot be asked; then nothing is written
 * @param written empty where nothing is written
 */
public record MonaResult(CheckResult check, Optional<Answered> settled, Optional<Written> written) {

    /**
     * A text that is written.
     *
     * @param leftStates how many states of the left side are spelled out
     */
    public record Written(String file, int leftStates, int rightStates) {}
}
