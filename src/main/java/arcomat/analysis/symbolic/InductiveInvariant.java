package arcomat.analysis.symbolic;

import arcomat.analysis.symbolic.PropertyDirectedReachability.Progress;

import java.util.List;
import java.util.Optional;

/**
 * States in which no run is ever: a proof that no bad step is possible, if it is one.
 *
 * @param excluded cubes, of literals that count positions of the state from 1 on
 */
public record InductiveInvariant(List<int[]> excluded) {
    public InductiveInvariant {
        excluded = List.copyOf(excluded);
    }

    /** Looks for one. What it finds is not to be believed, but to be checked. */
    public interface Search {
        /**
         * Works on for so long, a little more, or until it has come to an end.
         *
         * @param amount of assignments that a solver makes
         */
        Progress work(long amount);

        /** What was found, not yet checked. */
        Optional<InductiveInvariant> invariant();
    }

    /**
     * Whether it proves that no bad step is possible: no run begins in an excluded state, no step
     * leads to one from those that are not, and from these there is no bad step. The solver is not
     * believed: each of its conclusions is checked by unit propagation alone.
     *
     * @param between called on the way; may throw to give up
     */
    public boolean proves(TransitionRelation relation, Runnable between) {
        return excluded.stream().noneMatch(relation::beginsIn)
                && new CheckedSolver(question(relation), between).refutes();
    }

    /** A step from a state that is not excluded, which is bad, or leads to one that is. */
    private Clauses question(TransitionRelation relation) {
        Clauses clauses = relation.clauses().copy();
        int[] wrong = new int[excluded.size() + 1];
        for (int i = 0; i < excluded.size(); i++) {
            int[] cube = excluded.get(i);
            int[] outside = new int[cube.length];
            wrong[i] = clauses.variable();
            for (int j = 0; j < cube.length; j++) {
                outside[j] = -relation.before(cube[j]);
                clauses.add(-wrong[i], relation.after(cube[j]));
            }
            clauses.add(outside);
            clauses.add(-wrong[i], relation.goesOn());
        }
        wrong[excluded.size()] = relation.bad();
        clauses.add(wrong);
        return clauses;
    }
}
