package arcomat.simulate;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
        List<Watched> all = new ArrayList<>();
        for (Watch watch : watches) {
            Optional<Violation> violation = show(trace, watch);
            all.add(
                    new Watched(
                            watch.requirement(),
                            violation,
                            watch.satisfiedFrom(),
                            watch.unknown()));
        }
        return all;
    }

    private static Optional<Violation> show(Trace trace, Watch watch) {
        boolean events = trace.component().profile() == Component.Profile.EVENT_DRIVEN;
        if (events && trace.opening().isEmpty()) {
            return trace.end().map(end -> watch.endBefore());
        }
        Letter opening = trace.opening().orElse(Letter.SILENCE);
        Optional<Violation> found = watch.begin(opening);
        for (Trace.Step step : trace.steps()) {
            if (found.isEmpty()) {
                Letter before = step.number() == 0 ? opening : Letter.SILENCE;
                found = watch.see(step.inputs(), without(before, step.outputs()));
            }
        }
        return found.isPresent() || trace.end().isEmpty() ? found : watch.end(trace.end().get());
    }

    /** What is left of the messages of a step behind those of the opening. */
    private static Letter without(Letter opening, Letter shown) {
        Map<String, List<Value>> rest = new LinkedHashMap<>(shown.messages());
        opening.messages()
                .forEach(
                        (port, sent) -> rest.computeIfPresent(port, (p, all) -> behind(sent, all)));
        return new Letter(rest);
    }

    private static List<Value> behind(List<Value> sent, List<Value> all) {
        return all.subList(sent.size(), all.size());
    }
}
