package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.semantics.Promise;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * Every component refines itself. A search says more, that all of it is vacuous, say; but there
 * need not be an end of it.
 */
final class Reflexivity {
    private static final long MOST_PAIRS = 20_000;

    /** Steps of a search whose answer is known, whatever the machine's clock says. */
    private static final long PATIENCE = 2_000_000;

    private Reflexivity() {}

    /**
     * The verdict of a search, which gets less to spend where both sides are the same, and then
     * need not answer.
     */
    static Verdict check(
            Promise left, Promise right, Budget budget, Function<Budget, Verdict> search) {
        if (!isSame(left, right)) {
            return search.apply(budget);
        }
        Verdict verdict = search.apply(budget.atMost(MOST_PAIRS).patient(PATIENCE));
        String note =
                "holds because both sides are the same; not compared step by step: "
                        + verdict.reason();
        return verdict.answer() == Answer.UNKNOWN
                ? Verdict.holds(Optional.of(true), List.of(note), verdict.explored())
                : verdict;
    }

    /** Whether both sides are one and the same promise. */
    static boolean isSame(Promise left, Promise right) {
        return left.devices() == right.devices()
                && left.arguments().equals(right.arguments())
                && left.component().equals(right.component())
                && left.automata().equals(right.automata());
    }
}
