package arcomat.analysis.symbolic;

import java.util.List;

/**
 * A system in bits. Each step of it satisfies the clauses; where more does, less is proved.
 *
 * @param clauses about states before and after a step, and whatever else is needed to say it
 * @param state variables of the state before, at most 1,000,000
 * @param next those of the state afterwards, in the same order
 * @param alternative whether a variable is one of several of which exactly one is true
 * @param inputs variables that together with the state determine the step
 * @param goesOn a literal: there is a state afterwards
 * @param bad a literal: the step is one that must not be
 * @param initial the states in which a run may begin, each by the truth of its variables
 */
public record TransitionRelation(
        Clauses clauses,
        int[] state,
        int[] next,
        boolean[] alternative,
        int[] inputs,
        int goesOn,
        int bad,
        List<boolean[]> initial) {
    public TransitionRelation {
        initial = List.copyOf(initial);
    }

    /** A literal about the state before, of one that counts positions from 1 on. */
    int before(int literal) {
        return literal > 0 ? state[literal - 1] : -state[-literal - 1];
    }

    /** As above, about the state afterwards. */
    int after(int literal) {
        return literal > 0 ? next[literal - 1] : -next[-literal - 1];
    }

    /** Whether a run may begin in a state of which all those literals are true. */
    boolean beginsIn(int[] cube) {
        return initial.stream().anyMatch(each -> isIn(each, cube));
    }

    static boolean isIn(boolean[] state, int[] cube) {
        for (int literal : cube) {
            if (state[Math.abs(literal) - 1] != literal > 0) {
                return false;
            }
        }
        return true;
    }
}
