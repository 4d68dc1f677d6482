package statemachine;

import statemachine.Machine.Action;
import statemachine.Machine.Beginning;
import statemachine.Machine.Memory;
import statemachine.Machine.State;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Where a step ends up that enters a state, and what is done on the way. */
record Entering(StateTree states) {
    /**
     * @param last numbers of the simple states that have to have been the last; empty where that
     *     does not matter
     */
    record Way(State leaf, List<Action> actions, List<Integer> last) {}

    /** To begin with. */
    Way beginning() {
        List<Action> actions = new ArrayList<>();
        State leaf = begin(states.root(), actions);
        return new Way(leaf, actions, List.of());
    }

    /**
     * Into a state that is left in no other step meanwhile.
     *
     * @param outer the states from the outermost on that are entered, the last one is the target
     * @param current the simple state that is left, if it stands in the target
     */
    List<Way> into(List<State> outer, Memory memory, Optional<State> current) {
        State target = outer.get(outer.size() - 1);
        if (memory == Memory.NONE || target.isSimple()) {
            List<Action> actions = entries(outer);
            return List.of(new Way(begin(target, actions), actions, List.of()));
        }
        List<State> leaves = states.leaves(target);
        Map<State, List<Integer>> goals = new LinkedHashMap<>();
        for (int i = 0; i < leaves.size(); i++) {
            if (current.isEmpty() || current.get().equals(leaves.get(i))) {
                goals.computeIfAbsent(goal(target, leaves.get(i), memory), key -> new ArrayList<>())
                        .add(i);
            }
        }
        List<Way> ways = new ArrayList<>();
        goals.forEach(
                (goal, last) -> {
                    List<Action> actions = entries(outer);
                    List<State> path = states.path(goal);
                    actions.addAll(entries(path.subList(states.path(target).size(), path.size())));
                    State leaf = begin(goal, actions);
                    ways.add(new Way(leaf, actions, goals.size() == 1 ? List.of() : last));
                });
        return ways;
    }

    private State goal(State target, State leaf, Memory memory) {
        return memory == Memory.DEEP ? leaf : states.path(leaf).get(states.path(target).size());
    }

    private static List<Action> entries(List<State> entered) {
        List<Action> actions = new ArrayList<>();
        entered.forEach(each -> each.entry().ifPresent(actions::add));
        return actions;
    }

    /** Goes on from a state that was entered, by beginnings, to a simple one. */
    private State begin(State entered, List<Action> actions) {
        State current = entered;
        while (!current.isSimple()) {
            Beginning initial = current.initial().orElseThrow();
            initial.action().ifPresent(actions::add);
            current = states.state(initial.state());
            current.entry().ifPresent(actions::add);
        }
        return current;
    }
}
