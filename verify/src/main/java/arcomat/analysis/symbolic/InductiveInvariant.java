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
        return gap(relation, between).isEmpty();
    }

    /** What is missing; empty for a proof. As above. */
    public Optional<InvariantGap> gap(TransitionRelation relation, Runnable between) {
        for (int[] cube : excluded) {
            for (boolean[] state : relation.initial()) {
                if (TransitionRelation.isIn(state, cube)) {
                    return Optional.of(new InvariantGap.Begins(state, cube));
                }
            }
        }
        Question question = question(relation);
        CheckedSolver solver = new CheckedSolver(question.clauses, between);
        if (!solver.solveWith()) {
            return solver.isConclusive()
                    ? Optional.empty()
                    : Optional.of(new InvariantGap.Inconclusive());
        }
        return Optional.of(gap(relation, question, solver));
    }

    private InvariantGap gap(TransitionRelation relation, Question question, CheckedSolver found) {
        boolean[] state = found.truths(relation.state());
        boolean[] inputs = found.truths(relation.inputs());
        for (int i = 0; i < excluded.size(); i++) {
            if (found.isTrue(question.wrong[i])) {
                return new InvariantGap.Leads(
                        state, inputs, found.truths(relation.next()), excluded.get(i));
            }
        }
        return new InvariantGap.Bad(state, inputs);
    }

    /**
     * A question that has no answer where this is a proof.
     *
     * @param wrong literals of which one has to be true: what it leads to is in that cube
     */
    private record Question(Clauses clauses, int[] wrong) {}

    /** A step from a state that is not excluded, which is bad, or leads to one that is. */
    private Question question(TransitionRelation relation) {
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
        return new Question(clauses, wrong);
    }
}
