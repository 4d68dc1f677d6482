package statemachine;

import statemachine.Flattening.Arrow;
import statemachine.Machine.State;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * What may have been the last in a state, where a transition leads to its history. What cannot have
 * been is not asked about, and no mistake is told of it. Guards are not looked at, so that nothing
 * is missed.
 */
final class Histories {
    private final StateTree states;
    private final Entering entering;

    /** By the name of a simple state, those that a step leads to from there. */
    private final Map<String, Set<State>> next = new HashMap<>();

    /** By the name of a state, the names of the simple states from which it is left. */
    private final Map<String, Set<String>> leaving = new HashMap<>();

    /** By the name of a state, the names of the simple states before it was first entered. */
    private final Map<String, Set<String>> before = new HashMap<>();

    private Histories(StateTree states, Entering entering) {
        this.states = states;
        this.entering = entering;
    }

    /**
     * @param arrows all, with all ways
     */
    static Histories of(List<Arrow> arrows, StateTree states, Entering entering) {
        Histories histories = new Histories(states, entering);
        arrows.forEach(histories::note);
        return histories;
    }

    private void note(Arrow arrow) {
        String source = name(arrow.source());
        next.computeIfAbsent(source, key -> new HashSet<>()).add(arrow.way().leaf());
        for (State left : arrow.left()) {
            leaving.computeIfAbsent(name(left), key -> new HashSet<>()).add(source);
        }
    }

    /** The arrow without what cannot have been the last; nothing, if nothing is left. */
    Optional<Arrow> possible(Arrow arrow) {
        List<Integer> all = arrow.way().last();
        if (all.isEmpty()) {
            return Optional.of(arrow);
        }
        State goal = arrow.goal(states);
        Set<Integer> possible = possible(goal, arrow.source());
        Set<Integer> kept = new TreeSet<>(all);
        kept.retainAll(possible);
        if (kept.isEmpty()) {
            return Optional.empty();
        }
        if (kept.containsAll(possible)) {
            return Optional.of(arrow.after(List.of()));
        }
        int first = entering.first(goal);
        if (kept.contains(Entering.NOT_YET) && all.contains(first)) {
            kept.add(first);
        }
        return Optional.of(arrow.after(List.copyOf(kept)));
    }

    /** Numbers as those of {@link Entering.Way#last}; never empty. */
    private Set<Integer> possible(State goal, State source) {
        Set<Integer> possible = new TreeSet<>();
        Set<String> left = leaving.getOrDefault(name(goal), Set.of());
        List<State> leaves = states.leaves(goal);
        for (int i = 0; i < leaves.size(); i++) {
            if (left.contains(name(leaves.get(i)))) {
                possible.add(i);
            }
        }
        Set<String> notYet = before.computeIfAbsent(name(goal), key -> before(goal));
        if (notYet.contains(name(source)) || possible.isEmpty()) {
            possible.add(Entering.NOT_YET);
        }
        return possible;
    }

    /** Where the machine may be while it has not been in a state yet. */
    private Set<String> before(State goal) {
        Set<String> found = new HashSet<>();
        Deque<State> open = new ArrayDeque<>(List.of(entering.beginning().leaf()));
        while (!open.isEmpty()) {
            State current = open.remove();
            if (!states.isIn(current, goal) && found.add(name(current))) {
                open.addAll(next.getOrDefault(name(current), Set.of()));
            }
        }
        return found;
    }

    private static String name(State state) {
        return state.name().text();
    }
}
