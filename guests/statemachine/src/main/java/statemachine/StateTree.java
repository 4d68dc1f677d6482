package statemachine;

import statemachine.Machine.Label;
import statemachine.Machine.State;
import statemachine.Machine.Transition;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Which state stands in which.
 *
 * @param paths by the name of each state: from the outermost state that it stands in to itself
 * @param doubles names that another state has already
 * @param transitions of all states, in the order of the text
 */
record StateTree(
        State root,
        Map<String, List<State>> paths,
        List<Label> doubles,
        List<Transition> transitions) {

    static StateTree of(State root) {
        Map<String, List<State>> paths = new LinkedHashMap<>();
        List<Label> doubles = new ArrayList<>();
        List<Transition> transitions = new ArrayList<>(root.transitions());
        addAll(root, List.of(), paths, doubles, transitions);
        transitions.sort(Comparator.comparingInt(each -> each.place().start()));
        return new StateTree(root, paths, doubles, transitions);
    }

    private static void addAll(
            State whole,
            List<State> path,
            Map<String, List<State>> paths,
            List<Label> doubles,
            List<Transition> transitions) {
        for (State part : whole.states()) {
            List<State> longer = new ArrayList<>(path);
            longer.add(part);
            if (paths.putIfAbsent(part.name().text(), longer) != null) {
                doubles.add(part.name());
            }
            transitions.addAll(part.transitions());
            addAll(part, longer, paths, doubles, transitions);
        }
    }

    Optional<State> find(Label name) {
        return Optional.ofNullable(paths.get(name.text())).map(StateTree::last);
    }

    /** One that is there. */
    State state(Label name) {
        return find(name).orElseThrow();
    }

    /** From the outermost state to this one. */
    List<State> path(State state) {
        return Optional.ofNullable(paths.get(state.name().text())).orElse(List.of());
    }

    /** The simple states in a state; itself, if it is simple. */
    List<State> leaves(State state) {
        return state.isSimple()
                ? List.of(state)
                : state.states().stream().flatMap(each -> leaves(each).stream()).toList();
    }

    /** How many states are within one another. */
    int deepest() {
        return paths.values().stream().mapToInt(List::size).max().orElse(0);
    }

    boolean isIn(State inner, State outer) {
        return path(inner).contains(outer);
    }

    /** How many states, from the outermost on, are around both and are neither of them. */
    int around(State one, State other) {
        List<State> first = path(one).subList(0, path(one).size() - 1);
        List<State> second = path(other).subList(0, path(other).size() - 1);
        int common = 0;
        while (common < Math.min(first.size(), second.size())
                && first.get(common).equals(second.get(common))) {
            common++;
        }
        return common;
    }

    private static State last(List<State> path) {
        return path.get(path.size() - 1);
    }
}
