package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.model.Component;
import arcomat.semantics.Promise;

import java.util.Optional;

/**
 * Whether a refinement fails only because the left side answers later than the right one asks for.
 * Each delayed part of a composition takes a slice; a requirement that was written without thinking
 * of that asks for the right answers at the wrong time.
 */
final class Latency {
    /** Longer pipelines hold too many letters on the way. */
    private static final int MOST_SLICES = 8;

    /** A remark should not take much longer than the answer that it is about. */
    private static final long MOST_PAIRS = 20_000;

    /**
     * Steps that are computed for a remark: a second of work, whatever the machine's clock says.
     */
    private static final long PATIENCE = 500_000;

    private Latency() {}

    /**
     * The verdict, with a note if the failure is only one of latency. A wrong initial output is
     * not; events have no slices. Asked of compositions only: an automaton that is late was written
     * so.
     */
    static Verdict noted(Promise left, Promise right, Verdict verdict, Budget budget) {
        boolean late =
                verdict.answer() == Answer.FAILS
                        && verdict.trace().size() > 1
                        && left.isComposition()
                        && left.component().profile() == Component.Profile.TIME_SYNCHRONOUS;
        return late
                ? slices(left, right, budget)
                        .map(slices -> verdict.with(note(left, right, slices)))
                        .orElse(verdict)
                : verdict;
    }

    private static String note(Promise left, Promise right, int slices) {
        return ("only late: %s sends what %s asks for %d slice%s later"
                        + " (nothing is compared before the first of it)")
                .formatted(left.title(), right.title(), slices, slices == 1 ? "" : "s");
    }

    /**
     * The fewest slices after which all is in order; empty where that is never, or not known. No
     * part takes more than one.
     */
    private static Optional<Integer> slices(Promise left, Promise right, Budget budget) {
        int parts = left.network().instances().size();
        Budget hasty = budget.atMost(MOST_PAIRS).patient(PATIENCE);
        ComparedSystems systems = ComparedSystems.of(left, right, hasty);
        for (int slices = 1; slices <= parts; slices++) {
            if (slices > MOST_SLICES && budget.takes(Shortcut.LONG_PIPELINE)) {
                return Optional.empty();
            }
            Answer answer = answer(systems, slices, hasty);
            if (answer == Answer.UNKNOWN && !budget.takes(Shortcut.IMPATIENCE)) {
                answer = answer(ComparedSystems.of(left, right, budget), slices, budget);
            }
            if (answer != Answer.FAILS) {
                return answer == Answer.HOLDS ? Optional.of(slices) : Optional.empty();
            }
        }
        return Optional.empty();
    }

    private static Answer answer(ComparedSystems systems, int slices, Budget budget) {
        return Budget.within(() -> refines(systems, slices, budget), unknown -> Answer.UNKNOWN);
    }

    private static Answer refines(ComparedSystems systems, int slices, Budget budget) {
        TraceInclusion.Result result = compare(systems, slices, budget);
        if (result.failure().isPresent()) {
            return Answer.FAILS;
        }
        boolean complete = result.stopped().or(systems.left()::leftOut).isEmpty();
        return complete ? Answer.HOLDS : Answer.UNKNOWN;
    }

    /** With the right side so many slices late. */
    static TraceInclusion.Result compare(ComparedSystems systems, int slices, Budget budget) {
        return systems.late(slices, budget).inclusion(budget).run();
    }
}
