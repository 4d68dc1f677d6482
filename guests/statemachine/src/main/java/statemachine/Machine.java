package statemachine;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A state machine as it was written.
 *
 * @param declarations of variables, as they stand there
 * @param variables their names
 * @param priority who comes first, where several transitions are enabled
 * @param root what everything stands in; it has no name
 */
record Machine(List<Span> declarations, Set<String> variables, Priority priority, State root) {
    Machine {
        declarations = List.copyOf(declarations);
        variables = Set.copyOf(variables);
    }

    /** Who comes first. */
    enum Priority {
        /** Whoever: that is left open. */
        OPEN,
        /** Transitions of the states within. */
        INNER,
        /** Transitions of the states around. */
        OUTER
    }

    /** A name somewhere in the text. */
    record Label(Span place, String text) {}

    /**
     * A state with what stands in it; one without states in it is simple.
     *
     * @param initial where it begins
     */
    record State(
            Label name,
            List<State> states,
            Optional<Beginning> initial,
            Optional<Action> entry,
            Optional<Action> exit,
            Optional<During> during,
            List<Transition> transitions) {
        State {
            states = List.copyOf(states);
            transitions = List.copyOf(transitions);
        }

        boolean isSimple() {
            return states.isEmpty();
        }
    }

    /** {@code initial driving / {cmd = fwd};}. */
    record Beginning(Span place, Label state, Optional<Action> action) {}

    /** {@code do / {lamp = green};}: what is done in a step that no transition makes. */
    record During(Span place, Action action) {}

    /** {@code {cmd = fwd, tries = 0}}. */
    record Action(List<Item> items) {
        Action {
            items = List.copyOf(items);
        }
    }

    /**
     * One message, or one assignment.
     *
     * @param reads the names in its value
     */
    record Item(Span place, Label name, Set<String> reads) {
        Item {
            reads = Set.copyOf(reads);
        }
    }

    /**
     * {@code driving -> waiting [guard] {input} / {output};}.
     *
     * @param target none where nothing is left or entered
     * @param guard with its brackets
     * @param input with its braces
     */
    record Transition(
            Span place,
            Label source,
            Optional<Target> target,
            Optional<Span> guard,
            Optional<Span> input,
            Optional<Action> output) {}

    record Target(Label state, Memory memory) {}

    /** What a state goes on with when it is entered. */
    enum Memory {
        /** With its beginning. */
        NONE,
        /** With the state directly in it that was the last. */
        SHALLOW,
        /** With the innermost state that was the last. */
        DEEP
    }
}
