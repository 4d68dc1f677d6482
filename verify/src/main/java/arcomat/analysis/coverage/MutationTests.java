package arcomat.analysis.coverage;

import arcomat.analysis.coverage.DistinguishingSearch.Found;
import arcomat.analysis.coverage.DistinguishingSearch.Run;
import arcomat.analysis.coverage.Mutants.Mutant;
import arcomat.analysis.coverage.TransitionTests.Test;
import arcomat.analysis.coverage.TransitionTests.Untold;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * Goes on where tests that take every transition do not tell a component from one with a small
 * mistake: the proof that the component does something that the mistaken one does not is a run, and
 * that run is one more test. Time-synchronous: an event-driven test looks at whole streams only.
 */
final class MutationTests {
    /** Work in all: how often the budget is asked, which takes as often on every machine. */
    private static final long PATIENCE = 3_000_000;

    /** For one of many mistakes: it must not use up what there is for all. */
    private static final long SHARE = PATIENCE / 20;

    private static final long PAIRS = 5_000;

    /** Transitions of all mistaken automata together that are worth to be compiled. */
    private static final long MOST_TRANSITIONS = 300_000;

    private static final String NOT_LOOKED_AT =
            "neither this mistake nor any behind it was looked at, that takes too long";

    private static final String TOO_LONG = "to look for a run that shows it takes too long";

    private final List<Automaton> chosen;
    private final Promise promise;
    private final CodedComponent right;
    private final Budget budget;
    private final Budget again;
    private final List<Untold> untold = new ArrayList<>();

    /** Runs that show a mistake where the right component promises nothing any more. */
    private final List<Beyond> beyond = new ArrayList<>();

    private record Beyond(DistinguishingSearch distinction, Run run) {}

    /**
     * @param chosen an atomic component that works slice by slice, or some of its automata: those
     *     with mistakes
     */
    MutationTests(Promise chosen, Budget budget) {
        this.chosen = chosen.automata();
        this.promise = Promise.of(chosen.component(), chosen.arguments());
        this.right = CodedComponent.of(promise);
        this.budget = budget.atMost(PAIRS).patient(PATIENCE);
        this.again = budget.atMost(PAIRS).patient(PATIENCE);
    }

    /**
     * Adds tests to some.
     *
     * @param tests those that there are; more are added
     * @param named makes a test of a run
     * @return mistakes that are not told
     */
    List<Untold> tell(List<Test> tests, Function<Run, Test> named) {
        look(tests, named);
        for (Beyond each : beyond) {
            lastLook(each, tests, named);
        }
        return untold;
    }

    private void look(List<Test> tests, Function<Run, Test> named) {
        long compiled = 0;
        for (int i = 0; i < promise.automata().size(); i++) {
            Automaton automaton = promise.automata().get(i);
            if (!chosen.contains(automaton)) {
                continue;
            }
            for (Mutant mutant : new Mutants(promise.component(), automaton).all()) {
                compiled += automaton.transitions().size();
                if (compiled > MOST_TRANSITIONS || budget.isSpent()) {
                    untold.add(new Untold(mutant.mistake(), NOT_LOOKED_AT, false));
                    return;
                }
                look(mutant, promise.withAutomata(replaced(i, mutant.automaton())), tests, named);
            }
        }
    }

    private void look(
            Mutant mutant, Promise mistaken, List<Test> tests, Function<Run, Test> named) {
        Budget share = budget.patient(SHARE);
        DistinguishingSearch distinction =
                new DistinguishingSearch(
                        right, mutant.mistake(), mistaken, share, again.patient(SHARE));
        Found found = distinction.look(tests);
        found.untold().ifPresent(each -> untold.add(share.isSpent() ? tooLong(each) : each));
        found.run()
                .ifPresent(
                        run -> {
                            if (run.promised()) {
                                tests.add(named.apply(run));
                            } else {
                                beyond.add(new Beyond(distinction, run));
                            }
                        });
    }

    private static Untold tooLong(Untold each) {
        return new Untold(each.mistake(), TOO_LONG, false);
    }

    /** A test that ends in chaos is written where no other one tells the mistake. */
    private void lastLook(Beyond each, List<Test> tests, Function<Run, Test> named) {
        boolean told = Budget.within(() -> each.distinction.isTold(tests), spent -> false);
        if (!told) {
            tests.add(named.apply(each.run));
        }
    }

    private List<Automaton> replaced(int position, Automaton other) {
        List<Automaton> automata = new ArrayList<>(promise.automata());
        automata.set(position, other);
        return automata;
    }
}
