package statemachine;

import statemachine.Flattening.Arrow;
import statemachine.Machine.State;
import statemachine.Machine.Transition;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The states of which some step asks what was the last in them. The automaton has a variable for
 * each: the number of the simple state in it that was the last, in the order of the text. Where the
 * machine has not been in the state yet, it is the number of the one that the state begins with, or
 * {@link Entering#NOT_YET} where the beginning does more than to go on with that one.
 *
 * @param byName of the states
 * @param more names of those whose beginning does more
 */
record Remembered(
        Map<String, State> byName, Set<String> more, StateTree states, Entering entering) {
    /** An assignment. */
    record Value(String variable, int number) {}

    static Remembered by(List<Arrow> arrows, StateTree states, Entering entering) {
        Set<String> asked = new HashSet<>();
        Set<String> more = new HashSet<>();
        for (Arrow each : arrows) {
            List<Integer> last = each.way().last();
            if (!last.isEmpty()) {
                State goal = each.goal(states);
                asked.add(goal.name().text());
                if (last.contains(Entering.NOT_YET) && !last.contains(entering.first(goal))) {
                    more.add(goal.name().text());
                }
            }
        }
        Map<String, State> byName = new LinkedHashMap<>();
        for (Transition each : states.transitions()) {
            each.target()
                    .map(target -> states.state(target.state()))
                    .filter(state -> asked.contains(state.name().text()))
                    .ifPresent(state -> byName.put(state.name().text(), state));
        }
        return new Remembered(byName, more, states, entering);
    }

    /** No name of a model has this sign in it by chance. */
    static String variable(State state) {
        return state.name().text() + "$last";
    }

    String declaration(State state) {
        boolean doesMore = more.contains(state.name().text());
        return "variable Integer[%d..%d] %s = %d;"
                .formatted(
                        doesMore ? Entering.NOT_YET : 0,
                        states.leaves(state).size() - 1,
                        variable(state),
                        doesMore ? Entering.NOT_YET : entering.first(state));
    }

    /** The values of a state's variable for what may have been the last. */
    List<Integer> values(State state, List<Integer> last) {
        boolean doesMore = more.contains(state.name().text());
        return last.stream().filter(each -> doesMore || each != Entering.NOT_YET).toList();
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
