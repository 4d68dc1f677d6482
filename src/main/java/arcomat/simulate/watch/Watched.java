package arcomat.simulate.watch;

import arcomat.model.Trace;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * What became of a requirement in a run.
 *
 * @param requirement its name and line
 * @param violation empty if it was kept, as far as is known
 * @param nothingFrom the slice from which on it promised nothing any more
 * @param unknown why it cannot be said whether it was kept
 */
public record Watched(
        String requirement,
        Optional<Violation> violation,
        OptionalInt nothingFrom,
        Optional<String> unknown) {

    /** Shows a run to watches that have seen nothing yet. */
    public static List<Watched> all(List<Watch> watches, Trace trace) {
        Watching watching = new Watching(watches);
        trace.steps().forEach(step -> watching.see(trace.opening(), step));
        return watching.end(trace);
    }
}
