package arcomat.pipeline.analysis;

import arcomat.analysis.Difference;
import arcomat.pipeline.check.CheckResult;

import java.util.Optional;

/**
 * How two components compare.
 *
 * @param difference empty where the models have errors
 */
public record DiffResult(
        CheckResult check, String left, String right, Optional<Difference> difference) {}
