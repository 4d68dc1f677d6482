package arcomat.analysis.evolution;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Initial;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.Promise;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;

/** What differs between two versions of an automaton: transitions, beginning, completion. */
final class Edits {
    private final Automaton old;
    private final Automaton fresh;
    private final Promise after;
    private final int position;
    private final List<Edit> found;

    /**
     * @param position of the automaton in both versions
     */
    private Edits(Promise before, Promise after, int position, List<Edit> found) {
        this.old = before.automata().get(position);
        this.fresh = after.automata().get(position);
        this.after = after;
        this.position = position;
        this.found = found;
    }

    /**
     * One edit; a transition that reads the same as before and does something else is one.
     *
     * @param old place in the earlier version; empty for a new transition
     * @param fresh place in the later version; empty for a dropped transition
     * @param undone the later version without the edit; empty where it cannot be made
     */
    record Edit(Optional<Span> old, Optional<Span> fresh, Optional<Promise> undone) {}

    /** Those of automata that are there in both versions, one by one. */
    static List<Edit> between(Promise before, Promise after) {
        List<Edit> found = new ArrayList<>();
        int shared = Math.min(before.automata().size(), after.automata().size());
        for (int i = 0; i < shared; i++) {
            Edits edits = new Edits(before, after, i, found);
            edits.addTransitions();
            edits.addBeginning();
            edits.addCompletion();
        }
        return found;
    }

    /** Where a run begins and what it sends before anything is read: one edit as a whole. */
    private void addBeginning() {
        List<Initial> before = old.initials();
        List<Initial> now = fresh.initials();
        if (!texts(before, Initial::span).equals(texts(now, Initial::span))) {
            List<Initial> restored =
                    before.stream().flatMap(each -> restored(each).stream()).toList();
            boolean possible = restored.size() == before.size();
            found.add(
                    new Edit(
                            before.stream().map(Initial::span).findFirst(),
                            now.stream().map(Initial::span).findFirst(),
                            Optional.of(fresh.withInitials(restored))
                                    .filter(each -> possible)
                                    .map(this::with)));
        }
    }

    private void addCompletion() {
        if (old.completion() != fresh.completion()) {
            found.add(
                    new Edit(
                            Optional.of(old.span()),
                            Optional.of(fresh.span()),
                            Optional.of(with(fresh.with(old.completion())))));
        }
    }

    private void addTransitions() {
        List<Transition> dropped = without(old, fresh);
        for (Transition added : without(fresh, old)) {
            Optional<Transition> changed =
                    dropped.stream()
                            .filter(each -> trigger(old, each).equals(trigger(fresh, added)))
                            .findFirst();
            changed.ifPresent(dropped::remove);
            add(changed, Optional.of(added));
        }
        dropped.forEach(each -> add(Optional.of(each), Optional.empty()));
    }

    /** The transitions of one automaton that the other one does not have. */
    private static List<Transition> without(Automaton automaton, Automaton other) {
        Set<String> texts = texts(other.transitions(), Transition::span);
        List<Transition> rest = new ArrayList<>(automaton.transitions());
        rest.removeIf(transition -> texts.contains(text(transition.span())));
        return rest;
    }

    private void add(Optional<Transition> changed, Optional<Transition> added) {
        List<Transition> undone = new ArrayList<>(fresh.transitions());
        added.ifPresent(undone::remove);
        Optional<Transition> restored = changed.flatMap(this::restored);
        restored.ifPresent(undone::add);
        boolean possible = restored.isPresent() == changed.isPresent();
        found.add(
                new Edit(
                        changed.map(Transition::span),
                        added.map(Transition::span),
                        Optional.of(fresh.withTransitions(undone))
                                .filter(each -> possible)
                                .map(this::with)));
    }

    /** What makes a transition happen, as text: the state and the input, up to the output. */
    private static String trigger(Automaton automaton, Transition transition) {
        String read =
                text(transition.span())
                        .replaceFirst("^[^\\[{/;]*", "")
                        .replaceFirst("(/ ?\\{.*)?;$", "");
        return automaton.states().get(transition.source()) + " " + read.strip();
    }

    private static <T> Set<String> texts(List<T> all, Function<T, Span> place) {
        return all.stream().map(place).map(Edits::text).collect(Collectors.toSet());
    }

    /** Line breaks and blanks are no edits. */
    private static String text(Span span) {
        return span.text().replaceAll("\\s+", " ");
    }

    /** The later version with this automaton in place of its own. */
    private Promise with(Automaton automaton) {
        List<Automaton> automata = new ArrayList<>(after.automata());
        automata.set(position, automaton);
        return new Promise(after.component(), after.arguments(), automata);
    }

    /** A transition of the earlier version among the states and ports of the later one. */
    private Optional<Transition> restored(Transition each) {
        int source = now(each.source());
        int target = now(each.target());
        boolean possible =
                source >= 0
                        && target >= 0
                        && each.guard().isEmpty()
                        && each.assignments().isEmpty()
                        && each.matches().stream().allMatch(match -> isKept(match.port()))
                        && each.sends().stream().allMatch(send -> isKept(send.port()));
        return possible ? Optional.of(each.between(source, target)) : Optional.empty();
    }

    private Optional<Initial> restored(Initial initial) {
        int state = now(initial.state());
        boolean possible =
                state >= 0
                        && initial.assignments().isEmpty()
                        && initial.sends().stream().allMatch(send -> isKept(send.port()));
        return possible
                ? Optional.of(new Initial(state, initial.sends(), List.of(), initial.span()))
                : Optional.empty();
    }

    /** Where a state stands in the later version; negative if it is gone. */
    private int now(int state) {
        return fresh.states().indexOf(old.states().get(state));
    }

    private boolean isKept(Port port) {
        Component component = after.component();
        return component
                .port(port.name())
                .filter(p -> p.isInput() == port.isInput() && p.type().equals(port.type()))
                .isPresent();
    }
}
