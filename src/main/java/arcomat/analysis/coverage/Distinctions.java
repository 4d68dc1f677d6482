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
import arcomat.analysis.engine.RunErrors;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Sent;

import java.util.ArrayList;
import java.util.Comparator;
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

    private static final String BARRED = "every run that shows it errs or ends in chaos";

    private static final String BARRED_SO_FAR =
            "the runs that were found to show it err or end in chaos";

    /** For one of many mistakes. */
    private static final long PAIRS = 5_000;

    /** Transitions of all mistaken automata together that are worth to be compiled. */
    private static final long MOST_TRANSITIONS = 300_000;

    private final List<Automaton> chosen;
    private final Promise promise;
    private final Promise driven;

    /** Whether code sends nothing where no transition is enabled: no message has to be made up. */
    private final boolean isCodeSilent;

    /** Errs where it would promise nothing any more, or errs: all other runs promise something. */
    private final Promise promising;

    private final Budget budget;

    /** For second looks, so that they take nothing from the first ones. */
    private final Budget again;

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

    /** A run that shows a mistake where the right component promises nothing any more. */
    private record Beyond(Promise mistaken, Run run) {}

    private final List<Beyond> beyond = new ArrayList<>();

    /**
     * @param chosen an atomic component that works slice by slice, or some of its automata: those
     *     with mistakes
     */
    Distinctions(Promise chosen, Budget budget) {
        this.chosen = chosen.automata();
        this.promise = Promise.of(chosen.component(), chosen.arguments());
        this.budget = budget.atMost(PAIRS).patient(PATIENCE);
        this.again = budget.atMost(PAIRS).patient(PATIENCE);
        this.isCodeSilent = promise.component().outputs().stream().noneMatch(Port::total);
        this.driven = asRun();
        this.promising = promising();
    }

    /** As code runs it: where a completion leaves things open, nothing is sent. */
    private Promise asRun() {
        return isCodeSilent
                ? promise.withAutomata(
                        promise.automata().stream().map(Distinctions::asRun).toList())
                : promise;
    }

    private static Automaton asRun(Automaton automaton) {
        return automaton.completion() == Completion.ERROR
                ? automaton
                : automaton.with(Completion.IGNORE);
    }

    private Promise promising() {
        List<Automaton> automata = new ArrayList<>();
        for (int i = 0; i < promise.automata().size(); i++) {
            boolean chaos = promise.automata().get(i).completion() == Completion.CHAOS;
            Automaton own = driven.automata().get(i);
            automata.add(chaos ? own.with(Completion.ERROR) : own);
        }
        return promise.withAutomata(automata);
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
        firstLooks(tests, named, untold);
        for (Beyond each : beyond) {
            lastLook(each, named, tests).ifPresent(untold::add);
        }
        return untold;
    }

    private void firstLooks(List<Test> tests, Function<Run, Test> named, List<Untold> untold) {
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
                Promise mistaken = promise.withAutomata(replaced(i, mutant.automaton()));
                look(mutant.mistake(), mistaken, named, tests).ifPresent(untold::add);
            }
        }
    }

    /** A test that ends in chaos is written where no other one tells the mistake. */
    private Optional<Untold> lastLook(Beyond each, Function<Run, Test> named, List<Test> tests) {
        return Budget.within(
                () -> {
                    if (allowsAll(each.mistaken, tests)) {
                        tests.add(named.apply(each.run));
                    }
                    return Optional.empty();
                },
                spent -> Optional.of(new Untold(each.run.mistake, spent, false)));
    }

    private Optional<Untold> look(
            Mistake mistake, Promise mistaken, Function<Run, Test> named, List<Test> tests) {
        return Budget.within(
                () ->
                        allowsAll(mistaken, tests)
                                ? tell(mistake, mistaken, named, tests)
                                : Optional.empty(),
                spent -> Optional.of(new Untold(mistake, spent, false)));
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
            return Optional.of(new Untold(mistake, verdict.reason(), false));
        }
        Optional<Run> shortest = testable(mistake, verdict);
        if (shortest.isEmpty()) {
            return another(mistake, mistaken, verdict, named, tests);
        }
        tests.add(named.apply(shortest.get()));
        return Optional.empty();
    }

    /** The shortest run that is of use, where the shortest of all errs or ends in chaos. */
    private Optional<Untold> another(
            Mistake mistake,
            Promise mistaken,
            Verdict shortest,
            Function<Run, Test> named,
            List<Test> tests) {
        List<Verdict> found = new ArrayList<>(Refinement.failures(promising, mistaken, again));
        found.sort(Comparator.comparingInt(each -> each.trace().size()));
        boolean all = isPromisingAll();
        for (Verdict each : found) {
            boolean fails = each.answer() == Answer.FAILS;
            Optional<Run> run = fails ? testable(mistake, each) : Optional.empty();
            if (run.isPresent()) {
                tests.add(named.apply(run.get()));
                return Optional.empty();
            }
            all &= fails && errs(each);
        }
        if (isCodeSilent && !errs(shortest)) {
            beyond.add(new Beyond(mistaken, run(mistake, shortest.trace(), false)));
            return Optional.empty();
        }
        return Optional.of(new Untold(mistake, all ? BARRED : BARRED_SO_FAR, all));
    }

    /**
     * Whether no run that is of use was left out of that search: where one automaton is in chaos,
     * others may go on, and of a transition that goes wrong one run alone is told.
     */
    private boolean isPromisingAll() {
        boolean chaos =
                promise.automata().size() > 1
                        && promise.automata().stream()
                                .anyMatch(each -> each.completion() == Completion.CHAOS);
        return !chaos
                && promise.automata().stream()
                        .map(each -> each.with(Completion.IGNORE))
                        .noneMatch(RunErrors::arePossible);
    }

    /** A run that a test can ask for: it goes on, and something is promised at its end. */
    private Optional<Run> testable(Mistake mistake, Verdict failure) {
        if (errs(failure)) {
            return Optional.empty();
        }
        Run run = run(mistake, failure.trace(), true);
        boolean lost = new Following(promise, budget).isLost(run.inputs, run.expected);
        return lost ? Optional.empty() : Optional.of(run);
    }

    private static boolean errs(Verdict failure) {
        return failure.trace().stream().anyMatch(Moment::error);
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
                    Optional.of(
                            new Untold(mistake, "only what the model leaves open shows it", true));
            case UNKNOWN -> Optional.of(new Untold(mistake, verdict.reason(), false));
        };
    }

    private Run run(Mistake mistake, List<Moment> trace, boolean promised) {
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
        return new Run(mistake, inputs, expected, promised);
    }

    private static List<Value> messages(Sent sent) {
        return sent instanceof Sent.Messages messages ? messages.values() : List.of();
    }
}
