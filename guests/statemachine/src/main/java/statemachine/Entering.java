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
    /** Stands for the simple state that was the last, where the machine has not been yet. */
    static final int NOT_YET = -1;

    /**
     * @param last numbers of the simple states that have to have been the last, or {@link
     *     #NOT_YET}; empty where that does not matter
     */
    record Way(State leaf, List<Action> actions, List<Integer> last) {
        Way after(List<Integer> others) {
            return new Way(leaf, actions, List.copyOf(others));
        }
    }

    /** To begin with. */
    Way beginning() {
        List<Action> actions = new ArrayList<>();
        State leaf = begin(states.root(), actions);
        return new Way(leaf, actions, List.of());
    }

    /** The number of the simple state that a state begins with. */
    int first(State state) {
        return states.leaves(state).indexOf(begin(state, new ArrayList<>()));
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
            return List.of(throughBeginning(outer));
        }
        if (current.isPresent()) {
            return List.of(through(outer, goal(target, current.get(), memory)));
        }
        Map<Way, List<Integer>> ways = new LinkedHashMap<>();
        add(ways, throughBeginning(outer), NOT_YET);
        List<State> leaves = states.leaves(target);
        for (int i = 0; i < leaves.size(); i++) {
            add(ways, through(outer, goal(target, leaves.get(i), memory)), i);
        }
        return ways.entrySet().stream().map(each -> each.getKey().after(each.getValue())).toList();
    }

    /** The beginning is no way of its own where it is what going on with a state is. */
    private static void add(Map<Way, List<Integer>> ways, Way way, int last) {
        ways.computeIfAbsent(way, key -> new ArrayList<>()).add(last);
    }

    private State goal(State target, State leaf, Memory memory) {
        return memory == Memory.DEEP ? leaf : states.path(leaf).get(states.path(target).size());
    }

    private Way throughBeginning(List<State> outer) {
        List<Action> actions = entries(outer);
        State leaf = begin(outer.get(outer.size() - 1), actions);
        return new Way(leaf, actions, List.of());
    }

    /** Past the beginning of the target, to a state in it. */
    private Way through(List<State> outer, State goal) {
        int depth = states.path(outer.get(outer.size() - 1)).size();
        List<Action> actions = entries(outer);
        List<State> path = states.path(goal);
        actions.addAll(entries(path.subList(depth, path.size())));
        return new Way(begin(goal, actions), actions, List.of());
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
            initial.action().filter(action -> !action.items().isEmpty()).ifPresent(actions::add);
            current = states.state(initial.state());
            current.entry().ifPresent(actions::add);
        }
        return current;
    }
}
