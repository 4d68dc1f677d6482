package arcomat.analysis.automaton;

import arcomat.analysis.smt.Reachability;
import arcomat.analysis.smt.RunProperty;
import arcomat.analysis.smt.RunProperty.Difference;

import java.util.Map;
import java.util.Set;

/**
 * What is known about an automaton after looking at it: by trying, and by the solver where that did
 * not see everything.
 *
 * @param seen what some run shows
 * @param outcomes of the questions that were put to the solver
 */
record Knowledge(
        Exploration explored, Set<RunProperty> seen, Map<RunProperty, Reachability> outcomes) {

    /** Whether all configurations have been looked at, one by one. */
    boolean isExhaustive() {
        return explored.isComplete();
    }

    /** Whether it stays open, and matters: how two transitions differ only where they meet. */
    boolean isOpen(RunProperty question) {
        if (isCutOff(question)
                || !(outcomes.get(question) instanceof Reachability.Unknown)
                || happens(question)) {
            return false;
        }
        if (question instanceof RunProperty.Together together) {
            return switch (together.difference()) {
                case ANY -> true;
                case OUTPUT -> happens(together.with(Difference.ANY));
                case TARGET ->
                        happens(together.with(Difference.ANY))
                                && !happens(together.with(Difference.OUTPUT));
            };
        }
        return true;
    }

    /** Whether it asks for a state that no transitions lead to, whatever their guards say. */
    private boolean isCutOff(RunProperty question) {
        return question instanceof RunProperty.Reached reached
                && !explored.isConnected(reached.state());
    }

    /** Whether some run shows it. */
    boolean happens(RunProperty question) {
        return seen.contains(question);
    }

    /** Whether certainly no run shows it. */
    boolean neverHappens(RunProperty question) {
        if (happens(question)) {
            return false;
        }
        return isExhaustive()
                || isCutOff(question)
                || outcomes.get(question) instanceof Reachability.Unreachable;
    }
}
