package arcomat.simulate.watch;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.simulate.watch.Watch.Violation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;

/** Shows a run to watches, step by step; each is told of no more than its first violation. */
public final class Watching {
    private final List<Watch> watches;
    private final List<Optional<Violation>> found = new ArrayList<>();
    private boolean begun;

    /**
     * @param watches that have seen nothing yet
     */
    public Watching(List<Watch> watches) {
        this.watches = List.copyOf(watches);
        watches.forEach(each -> found.add(Optional.empty()));
    }

    /** Shows a whole run to watches that have seen nothing yet. */
    public static List<Watched> all(List<Watch> watches, Trace trace) {
        Watching watching = new Watching(watches);
        trace.steps().forEach(step -> watching.see(trace.opening(), step));
        return watching.end(trace);
    }

    /**
     * @param opening of the run, see {@link Trace#opening}
     */
    public void see(Optional<Letter> opening, Trace.Step step) {
        if (watches.isEmpty()) {
            return;
        }
        Letter before = opening.orElse(Letter.SILENCE);
        begin(before);
        Letter shown = step.number() == 0 ? without(before, step.outputs()) : step.outputs();
        show(watch -> watch.see(step.inputs(), shown));
    }

    /**
     * What became of them all.
     *
     * @param run as it ended; its steps have been seen
     */
    public List<Watched> end(Trace run) {
        boolean events = run.component().profile() == Component.Profile.EVENT_DRIVEN;
        if (events && run.opening().isEmpty()) {
            show(watch -> run.end().map(end -> watch.endBefore()));
        } else {
            begin(run.opening().orElse(Letter.SILENCE));
            show(watch -> run.end().flatMap(watch::end));
        }
        List<Watched> all = new ArrayList<>();
        for (int i = 0; i < watches.size(); i++) {
            Watch watch = watches.get(i);
            all.add(
                    new Watched(
                            watch.requirement(),
                            found.get(i),
                            watch.satisfiedFrom(),
                            watch.unknown()));
        }
        return all;
    }

    private void begin(Letter opening) {
        if (!begun) {
            begun = true;
            show(watch -> watch.begin(opening));
        }
    }

    /** Those that have found nothing yet look at what comes next. */
    private void show(Function<Watch, Optional<Violation>> next) {
        for (int i = 0; i < watches.size(); i++) {
            if (found.get(i).isEmpty()) {
                found.set(i, next.apply(watches.get(i)));
            }
        }
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
            Optional<String> unknown) {}
}
