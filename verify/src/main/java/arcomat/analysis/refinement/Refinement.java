package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.packed.PairStore;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Counterexample;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;

/**
 * Whether one component keeps what another one promises: every trace of the first, restricted to
 * the ports of the second, is a trace of the second (Ringert, Rumpe, Wortmann 2013, section 3). The
 * first may have further ports.
 */
public final class Refinement {
    private final Promise left;
    private final Promise right;
    private final ComparedSystems systems;
    private final TraceInclusion inclusion;

    private Refinement(
            Promise left, Promise right, Budget budget, Optional<PairStore.Maker> stores) {
        this.left = left;
        this.right = right;
        this.systems = ComparedSystems.of(left, right, budget);
        this.inclusion =
                systems.inclusion(
                        budget, () -> Optional.of(ComparedSystems.of(left, right, budget)), stores);
    }

    /** A conjunction on the right allows what each of its automata does: it is kept if each is. */
    public static Verdict check(Promise left, Promise right, Budget budget) {
        return check(left, right, budget, one -> Optional.empty());
    }

    /**
     * As above.
     *
     * @param stores of each that is compared with the left side, makes places for packed pairs;
     *     empty for those in memory
     */
    public static Verdict check(
            Promise left,
            Promise right,
            Budget budget,
            Function<Promise, Optional<PairStore.Maker>> stores) {
        Function<Budget, Verdict> whole = less -> whole(left, right, less, stores);
        return Budget.within(
                () ->
                        Reflexivity.check(
                                left, right, budget, less -> search(left, right, less, whole)),
                Verdict::unknown);
    }

    private static Verdict search(
            Promise left, Promise right, Budget budget, Function<Budget, Verdict> whole) {
        return comparable(left, right, budget::insist)
                .or(() -> CompositionalRefinement.check(left, right, budget, whole))
                .orElseGet(() -> whole.apply(budget));
    }

    /**
     * What there is to remark is asked last, and of what is told only: it may take all the time.
     */
    private static Verdict whole(
            Promise left,
            Promise right,
            Budget budget,
            Function<Promise, Optional<PairStore.Maker>> stores) {
        List<Promise> each = right.each();
        List<Verdict> verdicts =
                each.stream().map(one -> compare(left, one, budget, stores.apply(one))).toList();
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
        Optional<String> beginning = promise.obstacle(goOn);
        return beginning.isEmpty() && promise.isComposition()
                ? NetworkSystem.obstacle(promise.component(), promise.arguments())
                : beginning;
    }

    /** Fails as briefly as possible; holds only if all do, with what there is to say of each. */
    public static Verdict all(List<Verdict> verdicts) {
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
                Explored.together(explored, Math::max));
    }

    private static int rank(Verdict verdict) {
        return switch (verdict.answer()) {
            case HOLDS -> 0;
            case UNKNOWN -> 1;
            case FAILS -> 2;
        };
    }

    /** A side of a inclusion with a promise that has one automaton, or is a composition. */
    public static Verdict compare(Promise left, Promise right, Budget budget) {
        return compare(left, right, budget, certificate -> {});
    }

    /**
     * @param proof told why it holds, where it does
     */
    public static Verdict compare(
            Promise left,
            Promise right,
            Budget budget,
            Consumer<Supplier<Optional<Certificate>>> proof) {
        return compare(left, right, budget, Optional.empty(), proof);
    }

    static Verdict compare(
            Promise left, Promise right, Budget budget, Optional<PairStore.Maker> stores) {
        return compare(left, right, budget, stores, certificate -> {});
    }

    private static Verdict compare(
            Promise left,
            Promise right,
            Budget budget,
            Optional<PairStore.Maker> stores,
            Consumer<Supplier<Optional<Certificate>>> proof) {
        boolean conditions =
                stores.isEmpty()
                        && CoupledRefinement.isWorthwhile(left, right)
                        && budget.takes(Shortcut.CONDITIONS);
        return conditions
                ? withConditions(left, right, budget, proof)
                : byPairs(left, right, budget, stores, proof);
    }

    /** What a short search does not decide, conditions may show; else a long one follows. */
    private static Verdict withConditions(
            Promise left,
            Promise right,
            Budget budget,
            Consumer<Supplier<Optional<Certificate>>> proof) {
        Budget few = budget.atMost(CoupledRefinement.FEW_PAIRS);
        Verdict verdict = byPairs(left, right, few, Optional.empty(), proof);
        if (verdict.answer() != Answer.UNKNOWN) {
            return verdict;
        }
        CoupledRefinement.Attempt attempt = CoupledRefinement.attempt(left, right, budget);
        if (attempt.proof().isPresent()) {
            proof.accept(() -> attempt.proof().map(Supplier::get));
            return CoupledRefinement.verdict();
        }
        return attempt.noted(byPairs(left, right, budget, Optional.empty(), proof));
    }

    private static Verdict byPairs(
            Promise left,
            Promise right,
            Budget budget,
            Optional<PairStore.Maker> stores,
            Consumer<Supplier<Optional<Certificate>>> proof) {
        return Budget.within(
                () -> new Refinement(left, right, budget, stores).verdict(proof), Verdict::unknown);
    }

    private Verdict verdict(Consumer<Supplier<Optional<Certificate>>> proof) {
        return Budget.within(() -> searched(proof), this::unknown);
    }

    private Verdict unknown(String reason) {
        return Verdict.unknown(reason, explored());
    }

    private Verdict searched(Consumer<Supplier<Optional<Certificate>>> proof) {
        Verdict verdict = found(proof);
        return verdict.without(inclusion);
    }

    private Verdict found(Consumer<Supplier<Optional<Certificate>>> proof) {
        TraceInclusion.Result result = inclusion.run();
        if (result.failure().isPresent()) {
            return failure(result.failure().get(), this::explored);
        }
        Optional<String> stopped = result.stopped().or(systems.left()::leftOut);
        if (stopped.isPresent()) {
            return unknown(stopped.get());
        }
        proof.accept(inclusion::certificate);
        List<String> notes =
                Vacuity.notes(right, systems.right(), result, inclusion.invariant().isEmpty());
        return Verdict.holds(result.simulation(), notes, explored());
    }

    /** Counting comes last: the answer does not wait for it. */
    private Explored explored() {
        return systems.explored(inclusion);
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
                () -> new Refinement(left, right, budget, Optional.empty()).allFailures(),
                reason -> List.of(Verdict.unknown(reason)));
    }

    private List<Verdict> allFailures() {
        return Budget.within(this::allSearched, reason -> List.of(unknown(reason)));
    }

    private List<Verdict> allSearched() {
        TraceInclusion.Result result = inclusion.runOn();
        Explored explored = explored();
        List<Verdict> found = new ArrayList<>();
        inclusion.failures().forEach(each -> found.add(failure(each, () -> explored)));
        result.stopped()
                .or(systems.left()::leftOut)
                .ifPresent(why -> found.add(Verdict.unknown(why, explored)));
        return found;
    }

    /** What is forbidden by the steps that are known may be allowed by one that is left out. */
    private Verdict failure(TraceInclusion.Failure failure, Supplier<Explored> explored) {
        Optional<String> leftOut = systems.right().leftOut();
        if (leftOut.isPresent()) {
            return Verdict.unknown(leftOut.get(), explored.get());
        }
        Counterexample found = inclusion.counterexample(failure);
        List<Moment> trace = found.moments();
        int inputs = trace.size() - 1;
        List<Sentence> explanation = Explanation.of(left, right, found.forbidden(), inputs);
        Verdict verdict =
                Verdict.fails(trace, explanation, explored.get()).afterInputs(inputs, inclusion);
        List<String> shifted =
                systems.shifted().stream().filter(port -> isAsked(right, port)).toList();
        return shifted.isEmpty() ? verdict : verdict.with(shifted(shifted));
    }

    /** An automaton on a decomposed component asks about the ports that it writes. */
    private static boolean isAsked(Promise right, String port) {
        return !right.component().isComposite()
                || right.isComposition()
                || right.automata().stream()
                        .anyMatch(each -> ComponentSemantics.written(each).contains(port));
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
