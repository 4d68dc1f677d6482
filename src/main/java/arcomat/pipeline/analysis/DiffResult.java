package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Difference;
import arcomat.pipeline.check.CheckResult;

import java.util.Optional;

/**
 * How two components compare.
 *
 * @param difference empty where the models have errors
 */
public record DiffResult(
        CheckResult check, String left, String right, Optional<Difference> difference) {}
