package arcomat.campaign.coverage;

import java.util.List;

/**
 * What there is to cover in the automaton of a component, in whatever parts of robots it is.
 *
 * @param component qualified name
 * @param file of the model, as messages show it
 * @param transitions in the order of the text
 * @param states by their indices
 * @param initials states that it may begin in
 */
public record AutomatonItems(
        String component,
        String file,
        List<Transition> transitions,
        List<State> states,
        List<Integer> initials) {
    public AutomatonItems {
        transitions = List.copyOf(transitions);
        states = List.copyOf(states);
        initials = List.copyOf(initials);
    }

    /**
     * A transition.
     *
     * @param line in the model, from 1
     * @param text as it is written, in one line
     * @param target index of the state that it leads to
     * @param coded whether the program has it: where another one is always taken first, it does not
     */
    public record Transition(int line, String text, int target, boolean coded) {}

    /**
     * A state.
     *
     * @param line where it is declared, from 1
     */
    public record State(int line, String name) {}
}
