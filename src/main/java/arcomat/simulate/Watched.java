package arcomat.simulate;

import arcomat.model.Trace;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * What became of a requirement in a run.
 *
 * @param requirement its name and line
 * @param violation empty if it was kept
 * @param nothingFrom the slice from which on it promised nothing any more
 */
public record Watched(String requirement, Optional<Violation> violation, OptionalInt nothingFrom) {

    /** Shows a run to watches that have seen nothing yet. */
    public static List<Watched> all(List<Watch> watches, Trace trace) {
        List<Watched> all = new ArrayList<>();
        for (Watch watch : watches) {
            Optional<Violation> violation = Optional.empty();
            for (Trace.Step step : trace.steps()) {
                if (violation.isEmpty()) {
                    violation = watch.see(step.inputs(), step.outputs());
                }
            }
            all.add(new Watched(watch.requirement(), violation, watch.satisfiedFrom()));
        }
        return all;
    }
}
