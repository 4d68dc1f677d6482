package arcomat.pipeline;

import arcomat.model.Trace;

import java.util.Optional;

/**
 * What came of a simulation.
 *
 * @param check findings about the models
 * @param trace empty exactly if the findings did not let the model run
 */
public record SimulationResult(CheckResult check, Optional<Trace> trace) {}
