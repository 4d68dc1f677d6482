package arcomat.pipeline.analysis;

import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.refinement.Promise;
import arcomat.pipeline.check.CheckResult;

import java.util.Optional;

/**
 * Whether requirements contradict each other.
 *
 * @param found empty exactly where the models have errors
 * @param title whose requirements they are
 * @param asked the requirements; empty where the models have errors
 * @param controller the text of a controller that keeps them; empty where there is none
 * @param file where the controller was written; empty if it was not
 */
public record ContradictionsResult(
        CheckResult check,
        Optional<Consistency> found,
        String title,
        Optional<Promise> asked,
        Optional<String> controller,
        Optional<String> file) {}
