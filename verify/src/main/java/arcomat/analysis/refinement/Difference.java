package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.semantics.Promise;

import java.util.List;

/**
 * How two components compare.
 *
 * @param forward what the left one does and the right one forbids, one verdict for each step
 * @param backward what the right one does and the left one forbids
 */
public record Difference(Relation relation, List<Verdict> forward, List<Verdict> backward) {
    public Difference {
        forward = List.copyOf(forward);
        backward = List.copyOf(backward);
    }

    /** From the left to the right. */
    public enum Relation {
        EQUIVALENT,
        REFINES,
        IS_REFINED_BY,
        INCOMPARABLE,
        UNKNOWN
    }

    public static Difference of(Promise left, Promise right, Budget budget) {
        List<Verdict> forward = Refinement.failures(left, right, budget);
        List<Verdict> backward = Refinement.failures(right, left, budget);
        return new Difference(relation(answer(forward), answer(backward)), forward, backward);
    }

    private static Answer answer(List<Verdict> failures) {
        return failures.stream().map(Verdict::answer).reduce(Answer.HOLDS, Answer::and);
    }

    private static Relation relation(Answer forward, Answer backward) {
        if (forward == Answer.UNKNOWN || backward == Answer.UNKNOWN) {
            return Relation.UNKNOWN;
        }
        if (forward == Answer.HOLDS) {
            return backward == Answer.HOLDS ? Relation.EQUIVALENT : Relation.REFINES;
        }
        return backward == Answer.HOLDS ? Relation.IS_REFINED_BY : Relation.INCOMPARABLE;
    }
}
