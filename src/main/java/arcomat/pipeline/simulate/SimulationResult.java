package arcomat.pipeline.simulate;

import arcomat.model.Trace;
import arcomat.pipeline.check.CheckResult;
import arcomat.simulate.watch.Watching.Watched;

import java.util.List;
import java.util.Optional;

/**
 * What came of a simulation.
 *
 * @param check findings about the models
 * @param trace empty exactly if the findings did not let the model run
 * @param watched what became of the requirements that the run was watched for
 */
public record SimulationResult(CheckResult check, Optional<Trace> trace, List<Watched> watched) {
    public SimulationResult {
        watched = List.copyOf(watched);
    }
}
