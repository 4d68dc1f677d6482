package arcomat.laws;

import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.semantics.Promise;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;
import arcomat.simulate.watch.Watch;
import arcomat.simulate.watch.Watching;
import arcomat.simulate.watch.Watching.Watched;

import java.util.List;
import java.util.Map;

/** What laws ask again and again, with a bound that is the same on every machine. */
final class Questions {
    private static final long STATES = 2_000;
    private static final long PATIENCE = 20_000;

    private Questions() {}

    static Budget budget() {
        return new Budget(() -> false, STATES).patient(PATIENCE);
    }

    static Promise promise(Component component) {
        return Promise.of(component, List.of());
    }

    static Verdict refines(Component left, Component right) {
        return refines(promise(left), promise(right));
    }

    static Verdict refines(Promise left, Promise right) {
        return Refinement.check(left, right, budget());
    }

    static boolean holds(Verdict verdict) {
        return verdict.answer() == Answer.HOLDS;
    }

    static boolean fails(Verdict verdict) {
        return verdict.answer() == Answer.FAILS;
    }

    static String text(Verdict verdict) {
        String reason = verdict.reason().isEmpty() ? "" : " (" + verdict.reason() + ")";
        String steps =
                verdict.trace().isEmpty()
                        ? ""
                        : " after " + (verdict.trace().size() - 1) + " inputs";
        return verdict.answer().name().toLowerCase() + reason + steps;
    }

    static String command(String left, String right) {
        return "refines " + left + " " + right;
    }

    /**
     * Automata that contradict each other to begin with have no run, not even one that shows
     * nothing; each of them is refined until something is seen.
     */
    static boolean begins(Component component) {
        StreamTest nothing =
                new StreamTest(
                        "Run",
                        "nothing",
                        component,
                        List.of(),
                        List.of(),
                        Map.of(),
                        component.span());
        return StreamTests.run(nothing).verdict() != StreamTestResult.Verdict.FAILED;
    }

    /** What the monitors of all automata of a requirement say of a run. */
    static List<Watched> watched(Component required, Component running, Trace run) {
        List<Watch> watches =
                required.automata().stream()
                        .map(a -> new Watch(required, a, List.of(), running))
                        .toList();
        return Watching.all(watches, run);
    }
}
