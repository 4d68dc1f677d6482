package arcomat.semantics.automaton;

import arcomat.model.Refusal;

import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * States, transitions and initial clauses of one automaton that a moment of a trace takes and
 * reaches; several where a side may be in several states.
 *
 * @param states positions among the states of the automaton
 * @param transitions positions among its transitions
 * @param initials positions among its initial clauses; of the first moment only
 * @param nearest where no transition is enabled: for each place where a side may be, the one that
 *     needed least to be
 */
public record Visited(
        Set<Integer> states,
        Set<Integer> transitions,
        Set<Integer> initials,
        List<Refusal> nearest) {
    public Visited {
        states = sorted(states);
        transitions = sorted(transitions);
        initials = sorted(initials);
        nearest = List.copyOf(nearest);
    }

    private static Set<Integer> sorted(Set<Integer> numbers) {
        return Collections.unmodifiableSet(new TreeSet<>(numbers));
    }
}
