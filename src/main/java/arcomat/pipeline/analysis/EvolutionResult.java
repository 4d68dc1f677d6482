package arcomat.pipeline.analysis;

import arcomat.analysis.evolution.Evolution;
import arcomat.pipeline.check.CheckResult;

import java.util.Optional;

/**
 * What happened to promises along versions.
 *
 * @param evolution empty where the models have errors
 */
public record EvolutionResult(CheckResult check, Optional<Evolution> evolution) {}
