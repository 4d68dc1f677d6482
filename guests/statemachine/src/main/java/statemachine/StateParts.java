package statemachine;

import arcomat.source.Span;

import statemachine.Machine.Action;
import statemachine.Machine.Beginning;
import statemachine.Machine.During;
import statemachine.Machine.Label;
import statemachine.Machine.State;
import statemachine.Machine.Transition;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Gathers what stands in a state; what may be said once is not said twice. */
final class StateParts {
    private final List<State> states = new ArrayList<>();
    private final List<Transition> transitions = new ArrayList<>();
    private Optional<Beginning> initial = Optional.empty();
    private Optional<Action> entry = Optional.empty();
    private Optional<Action> exit = Optional.empty();
    private Optional<During> during = Optional.empty();

    void add(State state) {
        states.add(state);
    }

    void add(Transition transition) {
        transitions.add(transition);
    }

    void add(Beginning beginning) throws UnreadableText {
        once(initial, beginning.place(), "initial");
        initial = Optional.of(beginning);
    }

    void add(boolean atEntry, Span place, Action action) throws UnreadableText {
        once(atEntry ? entry : exit, place, atEntry ? "entry" : "exit");
        if (atEntry) {
            entry = Optional.of(action);
        } else {
            exit = Optional.of(action);
        }
    }

    void add(During action) throws UnreadableText {
        once(during, action.place(), "do");
        during = Optional.of(action);
    }

    private static void once(Optional<?> before, Span place, String word) throws UnreadableText {
        if (before.isPresent()) {
            throw new UnreadableText(
                    Mistake.SAID_TWICE,
                    place,
                    "this state has said '%s' already; put both together".formatted(word));
        }
    }

    State state(Label name) {
        return new State(name, states, initial, entry, exit, during, transitions);
    }
}
