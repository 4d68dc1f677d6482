package arcomat.analysis.evolution;

import arcomat.analysis.refinement.Promise;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Initial;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** What differs between two versions of an automaton: transitions, beginning, completion. */
final class Edits {
    private final Promise before;
    private final Promise after;

    Edits(Promise before, Promise after) {
        this.before = before;
        this.after = after;
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
    List<Edit> all() {
        List<Edit> edits = new ArrayList<>();
        int shared = Math.min(before.automata().size(), after.automata().size());
        for (int i = 0; i < shared; i++) {
            Automaton old = before.automata().get(i);
            Automaton fresh = after.automata().get(i);
            compare(old, fresh, i, edits);
            begin(old, fresh, i).ifPresent(edits::add);
            complete(old, fresh, i).ifPresent(edits::add);
        }
        return edits;
    }

    /** Where a run begins and what it sends before anything is read: one edit as a whole. */
    private Optional<Edit> begin(Automaton old, Automaton fresh, int position) {
        if (beginning(old).equals(beginning(fresh))) {
            return Optional.empty();
        }
        List<Initial> restored =
                old.initials().stream()
                        .flatMap(each -> restored(each, old, fresh).stream())
                        .toList();
        boolean possible = restored.size() == old.initials().size();
        return Optional.of(
                new Edit(
                        old.initials().stream().map(Initial::span).findFirst(),
                        fresh.initials().stream().map(Initial::span).findFirst(),
                        possible
                                ? Optional.of(with(position, fresh.withInitials(restored)))
                                : Optional.empty()));
    }

    private static Set<String> beginning(Automaton automaton) {
        Set<String> texts = new HashSet<>();
        automaton.initials().forEach(each -> texts.add(text(each.span())));
        return texts;
    }

    private Optional<Edit> complete(Automaton old, Automaton fresh, int position) {
        return old.completion() == fresh.completion()
                ? Optional.empty()
                : Optional.of(
                        new Edit(
                                Optional.of(old.span()),
                                Optional.of(fresh.span()),
                                Optional.of(with(position, fresh.with(old.completion())))));
    }

    private void compare(Automaton old, Automaton fresh, int position, List<Edit> edits) {
        List<Transition> dropped = without(old, fresh);
        for (Transition added : without(fresh, old)) {
            Optional<Transition> changed =
                    dropped.stream()
                            .filter(d -> trigger(old, d).equals(trigger(fresh, added)))
                            .findFirst();
            changed.ifPresent(dropped::remove);
            edits.add(edit(changed, Optional.of(added), old, fresh, position));
        }
        for (Transition each : dropped) {
            edits.add(edit(Optional.of(each), Optional.empty(), old, fresh, position));
        }
    }

    /** The transitions of one automaton that the other one does not have. */
    private static List<Transition> without(Automaton automaton, Automaton other) {
        Set<String> texts = new HashSet<>();
        other.transitions().forEach(transition -> texts.add(text(transition.span())));
        List<Transition> rest = new ArrayList<>(automaton.transitions());
        rest.removeIf(transition -> texts.contains(text(transition.span())));
        return rest;
    }

    private Edit edit(
            Optional<Transition> changed,
            Optional<Transition> added,
            Automaton old,
            Automaton fresh,
            int position) {
        List<Transition> undone = new ArrayList<>(fresh.transitions());
        added.ifPresent(undone::remove);
        Optional<Transition> restored = changed.flatMap(each -> restored(each, old, fresh));
        restored.ifPresent(undone::add);
        boolean possible = restored.isPresent() == changed.isPresent();
        return new Edit(
                changed.map(Transition::span),
                added.map(Transition::span),
                possible
                        ? Optional.of(with(position, fresh.withTransitions(undone)))
                        : Optional.empty());
    }

    /** What makes a transition happen, as text: the state and the input, up to the output. */
    private static String trigger(Automaton automaton, Transition transition) {
        String read =
                text(transition.span())
                        .replaceFirst("^[^\\[{/;]*", "")
                        .replaceFirst("(/ ?\\{.*)?;$", "");
        return automaton.states().get(transition.source()) + " " + read.strip();
    }

    /** Line breaks and blanks are no edits. */
    private static String text(Span span) {
        return span.text().replaceAll("\\s+", " ");
    }

    private Promise with(int position, Automaton automaton) {
        List<Automaton> automata = new ArrayList<>(after.automata());
        automata.set(position, automaton);
        return new Promise(after.component(), after.arguments(), automata);
    }

    /** A transition of the earlier version among the states and ports of the later one. */
    private Optional<Transition> restored(Transition transition, Automaton old, Automaton fresh) {
        int source = fresh.states().indexOf(old.states().get(transition.source()));
        int target = fresh.states().indexOf(old.states().get(transition.target()));
        boolean possible =
                source >= 0
                        && target >= 0
                        && transition.guard().isEmpty()
                        && transition.assignments().isEmpty()
                        && transition.matches().stream().allMatch(m -> isKept(m.port()))
                        && transition.sends().stream().allMatch(s -> isKept(s.port()));
        return possible
                ? Optional.of(
                        new Transition(
                                source,
                                target,
                                transition.guard(),
                                transition.matches(),
                                transition.sends(),
                                transition.assignments(),
                                transition.span()))
                : Optional.empty();
    }

    private Optional<Initial> restored(Initial initial, Automaton old, Automaton fresh) {
        int state = fresh.states().indexOf(old.states().get(initial.state()));
        boolean possible =
                state >= 0
                        && initial.assignments().isEmpty()
                        && initial.sends().stream().allMatch(s -> isKept(s.port()));
        return possible
                ? Optional.of(new Initial(state, initial.sends(), List.of(), initial.span()))
                : Optional.empty();
    }

    private boolean isKept(Port port) {
        Component component = after.component();
        return component
                .port(port.name())
                .filter(p -> p.isInput() == port.isInput() && p.type().equals(port.type()))
                .isPresent();
    }
}
