package arcomat.analysis.coverage;

import arcomat.analysis.coverage.TransitionTests.Mistake;
import arcomat.analysis.coverage.TransitionTests.Test;
import arcomat.analysis.coverage.TransitionTests.Untold;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Sent;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A component and the same with one mistake: a run that only the right one has.
 *
 * @param again for second looks, so that they take nothing from the first ones
 */
record DistinguishingSearch(
        CodedComponent right, Mistake mistake, Promise mistaken, Budget budget, Budget again) {
    private static final String BARRED = "every run that shows it errs or ends in chaos";

    private static final String BARRED_SO_FAR =
            "the runs that were found to show it err or end in chaos";

    private static final String LEFT_OPEN = "only what the model leaves open shows it";

    /**
     * A run that a mistaken component does not have.
     *
     * @param promised whether the right one promises something to the end of it
     */
    record Run(
            Mistake mistake,
            List<Letter> inputs,
            Map<String, List<List<Value>>> expected,
            boolean promised) {}

    /** What a look has found; nothing where tests tell the mistake, or where it is none. */
    record Found(Optional<Run> run, Optional<Untold> untold) {
        private static final Found NOTHING = new Found(Optional.empty(), Optional.empty());

        private static Found of(Run run) {
            return new Found(Optional.of(run), Optional.empty());
        }

        private static Found untold(Mistake mistake, String reason, boolean certain) {
            return new Found(Optional.empty(), Optional.of(new Untold(mistake, reason, certain)));
        }
    }

    Found look(List<Test> tests) {
        return Budget.within(
                () -> isTold(tests) ? Found.NOTHING : search(),
                spent -> Found.untold(mistake, spent, false));
    }

    /** Whether one of the tests fails. */
    boolean isTold(List<Test> tests) {
        TestOracle following = new TestOracle(mistaken, budget);
        return !tests.stream().allMatch(test -> following.allows(test.streams()));
    }

    private Found search() {
        Verdict verdict = Refinement.check(right.asRun(), mistaken, budget);
        if (verdict.answer() == Answer.HOLDS) {
            return leftOpen();
        }
        if (verdict.answer() == Answer.UNKNOWN) {
            return Found.untold(mistake, verdict.reason(), false);
        }
        return testable(verdict).map(Found::of).orElseGet(() -> another(verdict));
    }

    /** The shortest run that is of use, where the shortest of all errs or ends in chaos. */
    private Found another(Verdict shortest) {
        List<Verdict> failures =
                new ArrayList<>(Refinement.failures(right.promising(), mistaken, again));
        failures.sort(Comparator.comparingInt(each -> each.trace().size()));
        boolean all = right.isPromisingAll();
        for (Verdict each : failures) {
            boolean fails = each.answer() == Answer.FAILS;
            Optional<Run> run = fails ? testable(each) : Optional.empty();
            if (run.isPresent()) {
                return Found.of(run.get());
            }
            all &= fails && errs(each);
        }
        return right.silent() && !errs(shortest)
                ? Found.of(run(shortest.trace(), false))
                : Found.untold(mistake, all ? BARRED : BARRED_SO_FAR, all);
    }

    /** A run that a test can ask for: it goes on, and something is promised at its end. */
    private Optional<Run> testable(Verdict failure) {
        if (errs(failure)) {
            return Optional.empty();
        }
        Run run = run(failure.trace(), true);
        boolean lost = new TestOracle(right.promise(), budget).isLost(run.inputs, run.expected);
        return lost ? Optional.empty() : Optional.of(run);
    }

    private static boolean errs(Verdict failure) {
        return failure.trace().stream().anyMatch(Moment::error);
    }

    /** As it is run it does no less; what the model leaves open may still be missing. */
    private Found leftOpen() {
        if (!right.decides()) {
            return Found.NOTHING;
        }
        Verdict verdict = Refinement.check(right.promise(), mistaken, budget);
        return switch (verdict.answer()) {
            case HOLDS -> Found.NOTHING;
            case FAILS -> Found.untold(mistake, LEFT_OPEN, true);
            case UNKNOWN -> Found.untold(mistake, verdict.reason(), false);
        };
    }

    private Run run(List<Moment> trace, boolean promised) {
        List<Letter> inputs = trace.stream().skip(1).map(Moment::input).toList();
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        for (Port port : right.promise().component().outputs()) {
            expected.put(
                    port.name(),
                    trace.stream()
                            .skip(port.delay() > 0 ? 0 : 1)
                            .map(moment -> messages(moment.outputs().get(port.name())))
                            .toList());
        }
        return new Run(mistake, inputs, expected, promised);
    }

    private static List<Value> messages(@Nullable Sent sent) {
        return sent instanceof Sent.Messages messages ? messages.values() : List.of();
    }
}
