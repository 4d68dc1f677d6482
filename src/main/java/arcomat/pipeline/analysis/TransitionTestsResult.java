package arcomat.pipeline.analysis;

import arcomat.analysis.coverage.TransitionTests;
import arcomat.pipeline.check.CheckResult;

import java.util.Optional;

/**
 * What came of a wish for tests.
 *
 * @param found empty exactly where the models have errors
 * @param title what the tests are for
 * @param file path of the suite in the output folder; empty where there is no test to write
 */
public record TransitionTestsResult(
        CheckResult check, Optional<TransitionTests.Result> found, String title, String file) {}
