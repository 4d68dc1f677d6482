package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Comparison;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Automaton;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Whether one component keeps what another one promises: every trace of the first, restricted to
 * the ports of the second, is a trace of the second (Ringert, Rumpe, Wortmann 2013, section 3). The
 * first may have further ports.
 */
public final class Refinement {
    private Refinement() {}

    /** A conjunction on the right allows what each of its automata does: it is kept if each is. */
    public static Verdict check(Promise left, Promise right, Budget budget) {
        return Budget.within(
                () -> Reflexivity.check(left, right, budget, less -> search(left, right, less)),
                Verdict::unknown);
    }

    private static Verdict search(Promise left, Promise right, Budget budget) {
        return comparable(left, right, budget::insist)
                .or(
                        () ->
                                CompositionalRefinement.check(
                                        left, right, budget, less -> whole(left, right, less)))
                .orElseGet(() -> whole(left, right, budget));
    }

    /**
     * What there is to remark is asked last, and of what is told only: it may take all the time.
     */
    private static Verdict whole(Promise left, Promise right, Budget budget) {
        List<Promise> each = right.each();
        List<Verdict> verdicts = each.stream().map(one -> compare(left, one, budget)).toList();
        Verdict told = all(verdicts);
        int which = verdicts.indexOf(told);
        return which < 0 ? told : noted(left, each.get(which), told, budget);
    }

    private static Verdict noted(Promise left, Promise right, Verdict verdict, Budget budget) {
        return Budget.within(() -> Latency.noted(left, right, verdict, budget), stopped -> verdict);
    }

    /** The verdict where there is nothing to explore. */
    public static Optional<Verdict> comparable(Promise left, Promise right) {
        return comparable(left, right, () -> {});
    }

    /**
     * As above.
     *
     * @param goOn asked on the way; it may throw what ends the work
     */
    private static Optional<Verdict> comparable(Promise left, Promise right, Runnable goOn) {
        return Interfaces.compare(left, right)
                .or(
                        () ->
                                obstacle(left, goOn)
                                        .or(() -> obstacle(right, goOn))
                                        .map(Verdict::unknown));
    }

    private static Optional<String> obstacle(Promise promise, Runnable goOn) {
        Optional<String> beginning = Beginning.obstacle(promise, goOn);
        return beginning.isEmpty() && promise.isComposition()
                ? NetworkSystem.obstacle(promise.component(), promise.arguments())
                : beginning;
    }

    /** Fails as briefly as possible; holds only if all do, with what there is to say of each. */
    static Verdict all(List<Verdict> verdicts) {
        if (verdicts.size() == 1) {
            return verdicts.get(0);
        }
        Verdict worst = null;
        for (Verdict verdict : verdicts) {
            boolean shorter =
                    worst != null
                            && verdict.answer() == Answer.FAILS
                            && worst.answer() == Answer.FAILS
                            && verdict.trace().size() < worst.trace().size();
            if (worst == null || rank(verdict) > rank(worst) || shorter) {
                worst = verdict;
            }
        }
        if (worst == null) {
            return Vacuity.nothingAsked();
        }
        return worst.answer() == Answer.HOLDS ? together(verdicts) : worst;
    }

    /** There is a simulation of all where there is one of each. */
    private static Verdict together(List<Verdict> verdicts) {
        boolean simulation = verdicts.stream().allMatch(v -> v.simulation().orElse(true));
        boolean decided = verdicts.stream().allMatch(v -> v.simulation().isPresent());
        List<String> notes = verdicts.stream().flatMap(v -> v.notes().stream()).distinct().toList();
        List<Explored> explored = verdicts.stream().map(Verdict::explored).toList();
        return Verdict.holds(
                simulation && !decided ? Optional.empty() : Optional.of(simulation),
                notes,
                new Explored(
                        explored.stream().mapToLong(Explored::pairs).sum(),
                        explored.stream().mapToInt(Explored::left).max().orElse(0),
                        explored.stream().mapToInt(Explored::right).sum()));
    }

    private static int rank(Verdict verdict) {
        return switch (verdict.answer()) {
            case HOLDS -> 0;
            case UNKNOWN -> 1;
            case FAILS -> 2;
        };
    }

    /** A side of a comparison with a promise that has one automaton, or is a composition. */
    public static Verdict compare(Promise left, Promise right, Budget budget) {
        return compare(left, right, budget, certificate -> {});
    }

    /**
     * @param proof told why it holds, where it does
     */
    public static Verdict compare(
            Promise left, Promise right, Budget budget, Consumer<Supplier<Certificate>> proof) {
        return Budget.within(
                () -> compare(left, right, ComparedSystems.of(left, right, budget), budget, proof),
                Verdict::unknown);
    }

    private static Verdict compare(
            Promise left,
            Promise right,
            ComparedSystems sides,
            Budget budget,
            Consumer<Supplier<Certificate>> proof) {
        Comparison comparison = sides.comparison(budget);
        return Budget.within(
                () -> verdict(left, right, sides, comparison, proof),
                reason -> Verdict.unknown(reason, sides.explored(comparison.pairs())));
    }

    private static Verdict verdict(
            Promise left,
            Promise right,
            ComparedSystems sides,
            Comparison comparison,
            Consumer<Supplier<Certificate>> proof) {
        TraceInclusion.Result result = comparison.run();
        Explored explored = sides.explored(result.pairs());
        if (result.failure().isPresent()) {
            Verdict failure =
                    failure(left, right, sides, comparison, result.failure().get(), explored);
            return unlessLeftOut(sides.right(), failure);
        }
        Optional<String> stopped = result.stopped().or(sides.left()::leftOut);
        if (stopped.isPresent()) {
            return Verdict.unknown(stopped.get(), explored);
        }
        proof.accept(comparison::certificate);
        List<String> notes = Vacuity.notes(right, sides.right(), result);
        return Verdict.holds(result.simulation(), notes, explored);
    }

    /** What is forbidden by the steps that are known may be allowed by one that is left out. */
    private static Verdict unlessLeftOut(TransitionSystem right, Verdict failure) {
        return right.leftOut()
                .map(reason -> Verdict.unknown(reason, failure.explored()))
                .orElse(failure);
    }

    /**
     * All that the left side does and the right one forbids: one verdict for each step, with a
     * shortest trace to it. Empty where it holds; a single verdict where it is not known, or where
     * the interfaces differ.
     */
    public static List<Verdict> failures(Promise left, Promise right, Budget budget) {
        if (Reflexivity.isSame(left, right)) {
            return List.of();
        }
        Optional<Verdict> known = comparable(left, right);
        if (known.isPresent()) {
            return List.of(known.get());
        }
        List<Verdict> found = new ArrayList<>();
        for (Promise each : right.each()) {
            found.addAll(allFailures(left, each, budget));
        }
        return found;
    }

    private static List<Verdict> allFailures(Promise left, Promise right, Budget budget) {
        return Budget.within(
                () -> allFailures(left, right, ComparedSystems.of(left, right, budget), budget),
                reason -> List.of(Verdict.unknown(reason)));
    }

    private static List<Verdict> allFailures(
            Promise left, Promise right, ComparedSystems sides, Budget budget) {
        Comparison comparison = sides.comparison(budget);
        return Budget.within(
                () -> failures(left, right, sides, comparison),
                reason -> List.of(Verdict.unknown(reason, sides.explored(comparison.pairs()))));
    }

    private static List<Verdict> failures(
            Promise left, Promise right, ComparedSystems sides, Comparison comparison) {
        TraceInclusion.Result result = comparison.runOn();
        Explored explored = sides.explored(result.pairs());
        List<Verdict> found = new ArrayList<>();
        for (TraceInclusion.Failure each : comparison.failures()) {
            Verdict failure = failure(left, right, sides, comparison, each, explored);
            found.add(unlessLeftOut(sides.right(), failure));
        }
        result.stopped()
                .or(sides.left()::leftOut)
                .ifPresent(why -> found.add(Verdict.unknown(why, explored)));
        return found;
    }

    private static Verdict failure(
            Promise left,
            Promise right,
            ComparedSystems sides,
            Comparison comparison,
            TraceInclusion.Failure failure,
            Explored explored) {
        List<Moment> trace = comparison.moments(failure);
        List<Sentence> explanation =
                Explanation.of(left, right, comparison.forbidden(failure), trace.size() - 1);
        Verdict verdict = Verdict.fails(trace, explanation, explored);
        List<String> shifted =
                sides.shifted().stream().filter(port -> isAsked(right, port)).toList();
        return shifted.isEmpty() ? verdict : verdict.with(shifted(shifted));
    }

    /** An automaton on a decomposed component asks about the ports that it writes. */
    private static boolean isAsked(Promise right, String port) {
        return !right.component().isComposite()
                || right.isComposition()
                || right.automata().stream().anyMatch(automaton -> writes(automaton, port));
    }

    private static boolean writes(Automaton automaton, String port) {
        return Stream.concat(
                        automaton.initials().stream().map(Automaton.Initial::sends),
                        automaton.transitions().stream().map(Automaton.Transition::sends))
                .flatMap(List::stream)
                .anyMatch(send -> send.port().name().equals(port));
    }

    /** A step pairs an input with its reaction; not where the delays of both sides differ. */
    private static String shifted(List<String> ports) {
        return "the two send with different delays; %s each in the slice in which it is seen"
                .formatted(
                        ports.stream()
                                        .map(port -> "'" + port + "'")
                                        .collect(Collectors.joining(", "))
                                + (ports.size() == 1 ? " stands" : " stand"));
    }
}
