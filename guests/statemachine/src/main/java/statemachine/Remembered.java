package statemachine;

import statemachine.Machine.Memory;
import statemachine.Machine.State;
import statemachine.Machine.Transition;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The states that something comes back to. The automaton has a variable for each: the number of the
 * simple state in it that was the last, in the order of the text.
 *
 * @param byName of the states
 */
record Remembered(Map<String, State> byName, StateTree states) {
    /** An assignment, or a declaration. */
    record Value(String variable, int number) {}

    static Remembered in(StateTree states) {
        Map<String, State> all = new LinkedHashMap<>();
        for (Transition each : states.transitions()) {
            each.target()
                    .filter(target -> target.memory() != Memory.NONE)
                    .map(target -> states.state(target.state()))
                    .ifPresent(state -> all.put(state.name().text(), state));
        }
        return new Remembered(all, states);
    }

    /** No name of a model has this sign in it by chance. */
    static String variable(State state) {
        return state.name().text() + "$last";
    }

    /** What is noted when a simple state is left, and some of those that it stands in. */
    List<Value> noted(State leaf, List<State> left) {
        List<Value> values = new ArrayList<>();
        for (State each : left) {
            if (byName.containsKey(each.name().text())) {
                values.add(new Value(variable(each), states.leaves(each).indexOf(leaf)));
            }
        }
        return values;
    }
}
