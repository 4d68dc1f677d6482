package arcomat.analysis.coverage;

import arcomat.analysis.Budget;
import arcomat.analysis.Moment;
import arcomat.analysis.Promise;
import arcomat.analysis.Refinement;
import arcomat.analysis.Verdict;
import arcomat.analysis.Verdict.Answer;
import arcomat.analysis.coverage.Mutants.Mutant;
import arcomat.analysis.coverage.TransitionTests.Mistake;
import arcomat.analysis.coverage.TransitionTests.Test;
import arcomat.analysis.coverage.TransitionTests.Untold;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Sent;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * Goes on where tests that take every transition do not tell a component from one with a small
 * mistake: the proof that the component does something that the mistaken one does not is a run, and
 * that run is one more test. Time-synchronous: an event-driven test looks at whole streams only.
 */
final class Distinctions {
    /** Work in all, in steps that are computed: seconds, the same on every machine. */
    private static final long PATIENCE = 3_000_000;

    private static final String NOT_LOOKED_AT =
            "neither this mistake nor any behind it was looked at, that takes too long";

    /** For one of many mistakes. */
    private static final long PAIRS = 5_000;

    /** Transitions of all mistaken automata together that are worth to be compiled. */
    private static final long MOST_TRANSITIONS = 300_000;

    private final List<Automaton> chosen;
    private final Promise promise;
    private final Promise driven;
    private final Budget budget;

    /** A run that a mistaken component does not have. */
    record Run(Mistake mistake, List<Letter> inputs, Map<String, List<List<Value>>> expected) {}

    /**
     * @param chosen an atomic component that works slice by slice, or some of its automata: those
     *     with mistakes
     */
    Distinctions(Promise chosen, Budget budget) {
        this.chosen = chosen.automata();
        this.promise = Promise.of(chosen.component(), chosen.arguments());
        this.budget = budget.atMost(PAIRS).patient(PATIENCE);
        this.driven = asRun(promise);
    }

    /** As code runs it: where a completion leaves things open, nothing is sent. */
    private static Promise asRun(Promise promise) {
        boolean silent = promise.component().outputs().stream().noneMatch(Port::total);
        return silent
                ? promise.withAutomata(
                        promise.automata().stream().map(Distinctions::asRun).toList())
                : promise;
    }

    private static Automaton asRun(Automaton automaton) {
        return automaton.completion() == Completion.ERROR
                ? automaton
                : automaton.with(Completion.IGNORE);
    }

    /**
     * Adds tests to some.
     *
     * @param tests those that there are; more are added
     * @param named makes a test of a run
     * @return mistakes that are not told
     */
    List<Untold> tell(List<Test> tests, Function<Run, Test> named) {
        List<Untold> untold = new ArrayList<>();
        long compiled = 0;
        for (int i = 0; i < promise.automata().size(); i++) {
            Automaton automaton = promise.automata().get(i);
            if (!chosen.contains(automaton)) {
                continue;
            }
            for (Mutant mutant : new Mutants(promise.component(), automaton).all()) {
                compiled += automaton.transitions().size();
                if (compiled > MOST_TRANSITIONS || budget.isSpent()) {
                    untold.add(new Untold(mutant.mistake(), NOT_LOOKED_AT));
                    return untold;
                }
                Promise mistaken = promise.withAutomata(replaced(i, mutant.automaton()));
                if (allowsAll(mistaken, tests)) {
                    tell(mutant.mistake(), mistaken, named, tests).ifPresent(untold::add);
                }
            }
        }
        return untold;
    }

    private boolean allowsAll(Promise mistaken, List<Test> tests) {
        Following following = new Following(mistaken, budget);
        return tests.stream().allMatch(test -> following.allows(test.streams()));
    }

    private List<Automaton> replaced(int position, Automaton other) {
        List<Automaton> automata = new ArrayList<>(promise.automata());
        automata.set(position, other);
        return automata;
    }

    private Optional<Untold> tell(
            Mistake mistake, Promise mistaken, Function<Run, Test> named, List<Test> tests) {
        Verdict verdict = Refinement.check(driven, mistaken, budget);
        if (verdict.answer() == Answer.HOLDS) {
            return leftOpen(mistake, mistaken);
        }
        if (verdict.answer() == Answer.UNKNOWN) {
            return Optional.of(new Untold(mistake, verdict.reason()));
        }
        if (verdict.trace().stream().anyMatch(Moment::error)) {
            return Optional.of(new Untold(mistake, "the shortest run that shows it errs"));
        }
        Run run = run(mistake, verdict.trace());
        if (new Following(promise, budget).isLost(run.inputs, run.expected)) {
            return Optional.of(new Untold(mistake, "the shortest run that shows it ends in chaos"));
        }
        tests.add(named.apply(run));
        return Optional.empty();
    }

    /** As it is run it does no less; what the model leaves open may still be missing. */
    private Optional<Untold> leftOpen(Mistake mistake, Promise mistaken) {
        if (driven.equals(promise)) {
            return Optional.empty();
        }
        Verdict verdict = Refinement.check(promise, mistaken, budget);
        return switch (verdict.answer()) {
            case HOLDS -> Optional.empty();
            case FAILS ->
                    Optional.of(new Untold(mistake, "only what the model leaves open shows it"));
            case UNKNOWN -> Optional.of(new Untold(mistake, verdict.reason()));
        };
    }

    private Run run(Mistake mistake, List<Moment> trace) {
        List<Letter> inputs = trace.stream().skip(1).map(Moment::input).toList();
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        for (Port port : promise.component().outputs()) {
            expected.put(
                    port.name(),
                    trace.stream()
                            .skip(port.delay() > 0 ? 0 : 1)
                            .map(moment -> messages(moment.outputs().get(port.name())))
                            .toList());
        }
        return new Run(mistake, inputs, expected);
    }

    private static List<Value> messages(Sent sent) {
        return sent instanceof Sent.Messages messages ? messages.values() : List.of();
    }
}
