package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.composition.GlobalState;
import arcomat.analysis.search.encoding.SymbolicInclusion;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.analysis.search.packed.PairStore;
import arcomat.analysis.search.step.CubeSplit;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.analysis.search.system.PackableSystem;
import arcomat.analysis.search.system.TransitionSystem;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.semantics.value.GivenUp;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;

/**
 * Whether every trace of the left side is one of the right side: breadth first over a configuration
 * of the left and the macro state of all configurations that the right may be in (subset
 * construction), without the pairs that an {@link Antichain} leaves out, and those where the right
 * may be in chaos and the left cannot err.
 *
 * <p>The counterexample is shortest, and among those has fewest messages, and among those comes
 * first in the order of declaration.
 */
public final class TraceInclusion {
    /** So many letters the question whether there is a simulation may take, whoever asks. */
    private static final long LITTLE_WORK = 300_000;

    /** So many pairs are looked at where letters are left out, so that it cannot hold any more. */
    private static final long SOME_PAIRS = 1_000;

    /** Beyond that, so many times as many as the search itself has tried. */
    private static final long FACTOR = 8;

    /** Of more packed pairs it is not asked whether there is a simulation: that is not packed. */
    private static final long MOST_SIMULATED = 10_000;

    private final Product product;
    private final Budget budget;
    private final SimulationRelation simulation;
    private final Antichain pairs;
    private final SymbolicTurns symbolic;
    private final PairStore.Maker stores;
    private boolean chaosReached;
    private boolean promising;
    private @Nullable PackedInclusion packed;
    private List<String> leftOut = List.of();
    private @Nullable Failure best;
    private final Map<Kind, Failure> failures = new LinkedHashMap<>();
    private boolean goesOn;
    private int level;
    private long tried;

    /**
     * @param observed the output ports of the right side, as cubes list them
     */
    public TraceInclusion(
            TransitionSystem left,
            TransitionSystem right,
            List<Port> observed,
            OutputCubes outputs,
            Budget budget) {
        this(left, right, observed, outputs, budget, Optional::empty, Optional.empty());
    }

    /**
     * @param observed the output ports of the right side, as cubes list them
     * @param symbolic makes an engine for the same question, which is asked beside a long search
     *     and ends it where it has proved the inclusion
     * @param stores makes places for packed pairs; empty for those in memory
     */
    public TraceInclusion(
            TransitionSystem left,
            TransitionSystem right,
            List<Port> observed,
            OutputCubes outputs,
            Budget budget,
            Supplier<Optional<SymbolicInclusion>> symbolic,
            Optional<PairStore.Maker> stores) {
        this.stores = stores.orElse(PackedPairs::new);
        this.symbolic = new SymbolicTurns(symbolic, budget);
        this.product = new Product(left, right, observed, outputs, budget);
        this.budget = budget;
        this.simulation = new SimulationRelation(product, budget);
        this.pairs = new Antichain(product.sets, simulation, budget);
    }

    /**
     * What the search found.
     *
     * @param failure where the left side does what the right one forbids
     * @param stopped why the search ended before it was done
     * @param simulation whether the right side simulates the left one; empty where that was not
     *     decided
     * @param chaosReached whether some run is allowed only because the right side is in chaos
     * @param promising whether the right side is not in chaos after some input
     * @param pairs how many were explored
     */
    public record Result(
            Optional<Failure> failure,
            Optional<String> stopped,
            Optional<Boolean> simulation,
            boolean chaosReached,
            boolean promising,
            long pairs) {}

    /**
     * The forbidden step.
     *
     * @param node the pair before it, or {@link Antichain#NONE} for a forbidden beginning
     * @param alphabet null for a forbidden beginning
     * @param step position among the left side's steps
     * @param level its number of inputs
     */
    public record Failure(
            int node,
            @Nullable Alphabet alphabet,
            int letter,
            Steps steps,
            int step,
            CubeSplit.Case sent,
            int cost,
            int level) {}

    /** Failures are alike that do the same, or go wrong in doing the same. */
    private record Kind(List<Trace.Cause> causes, boolean error) {}

    /** Ends with the first failure, or where time, memory or letters are too much. */
    public Result run() {
        return run(false);
    }

    /** As {@link #run}, but goes on behind failures, to find one for each cause. */
    public Result runOn() {
        return run(true);
    }

    private Result run(boolean on) {
        goesOn = on;
        try {
            return levels();
        } catch (GivenUp inTheMiddle) {
            return result(Optional.of(String.valueOf(inTheMiddle.getMessage())));
        }
    }

    private Result levels() {
        return packed().orElseGet(this::unpacked);
    }

    /** The same answer from packed configurations; empty where these cannot be had. */
    private Optional<Result> packed() {
        if (goesOn) {
            return Optional.empty();
        }
        if (!PackedInclusion.isFor(product) || !budget.takes(Shortcut.PACKED)) {
            return Optional.empty();
        }
        if (!(product.left instanceof NetworkSystem whole) || !whole.worksInSlices()) {
            return packed(product, (PackableSystem) product.left, state -> state);
        }
        NetworkSystem.Smaller smaller = whole.smaller();
        leftOut = smaller.network().leftOut();
        Optional<Result> result =
                packed(product.with(smaller.system()), whole, smaller.network()::image);
        if (result.isEmpty()) {
            leftOut = List.of();
        }
        return result.or(() -> packed(product, whole, state -> state));
    }

    /**
     * @param image what a configuration of the whole is in the question that is asked instead
     */
    private Optional<Result> packed(
            Product asked, PackableSystem whole, UnaryOperator<GlobalState> image) {
        Optional<PackedInclusion> search = PackedInclusion.of(asked, budget, symbolic, stores);
        if (search.isEmpty()) {
            return Optional.empty();
        }
        packed = search.get();
        Optional<PackedInclusion.Found> found = packed.run();
        if (found.isEmpty()) {
            packed = null;
            return Optional.empty();
        }
        chaosReached = found.get().chaosReached();
        promising = found.get().promising();
        if (!found.get().path().isEmpty()) {
            retrace(found.get(), search.get(), state -> image.apply(whole.state(state)));
        }
        return Optional.of(result(found.get().stopped()));
    }

    /** Follows a failure as the unpacked search would have found it. */
    private void retrace(
            PackedInclusion.Found found, PackedInclusion search, IntFunction<GlobalState> image) {
        int node = Antichain.NONE;
        for (long[] pair : found.path()) {
            node = retrace(node, (left, set) -> search.isAt(pair, image.apply(left), set));
        }
        level = found.path().size();
        expand(node);
        if (best == null || best.cost() != found.cost()) {
            throw new AssertionError("packed configurations fail otherwise");
        }
    }

    /** A pair that is known to follow, told by its left side and its set. */
    private interface Followed {
        boolean isAt(int left, int set);
    }

    /** The first of the cheapest steps to a pair that is known to follow. */
    private int retrace(int node, Followed to) {
        Cheapest cheapest = new Cheapest(to);
        if (node == Antichain.NONE) {
            cheapest.compare(product.left.openings(), product.right.openings(), 0);
        } else {
            Alphabet alphabet = product.alphabet(pairs.left(node), pairs.set(node));
            Steps[] own = product.leftSteps(pairs.left(node), alphabet);
            for (int letter = 0; letter < own.length; letter++) {
                Steps theirs = product.answers(pairs.set(node), alphabet, letter);
                int cost = pairs.cost(node) + alphabet.messages(letter);
                cheapest.compare(own[letter], theirs, cost);
            }
        }
        if (cheapest.set < 0) {
            throw new AssertionError("packed configurations go on otherwise");
        }
        pairs.add(node, cheapest.left, cheapest.set, cheapest.cost, 0);
        pairs.nextLevel();
        return pairs.size() - 1;
    }

    /** Of some steps, the first that takes fewest messages. */
    private final class Cheapest {
        private final Followed to;
        private int left;
        private int set = -1;
        private int cost = Integer.MAX_VALUE;

        Cheapest(Followed to) {
            this.to = to;
        }

        void compare(Steps mine, Steps theirs, int before) {
            for (int step = 0; step < mine.size(); step++) {
                for (CubeSplit.Case sent : product.cases(mine.outputs()[step], theirs)) {
                    int total = before + sent.messages();
                    if (sent.allowed().length > 0 && total < cost) {
                        int next = product.successor(theirs, sent.allowed());
                        if (next >= 0 && to.isAt(mine.next()[step], next)) {
                            left = mine.next()[step];
                            set = next;
                            cost = total;
                        }
                    }
                }
            }
        }
    }

    private Result unpacked() {
        open();
        int[] frontier = pairs.nextLevel();
        while (frontier.length > 0 && (best == null || goesOn)) {
            level++;
            for (int node : frontier) {
                String exhausted = budget.exhausted(pairs.size());
                if (exhausted != null) {
                    return result(product.missing().or(() -> Optional.of(exhausted)));
                }
                if (product.missing().isPresent() && pairs.size() > SOME_PAIRS) {
                    return result(product.missing());
                }
                expand(node);
            }
            frontier = pairs.nextLevel();
        }
        return result(product.missing());
    }

    private Result result(Optional<String> stopped) {
        Optional<Boolean> simulated =
                stopped.isPresent()
                        ? Optional.empty()
                        : best != null
                                ? Optional.of(false)
                                : invariant().isPresent() ? Optional.empty() : simulated();
        return new Result(
                Optional.ofNullable(best), stopped, simulated, chaosReached, promising, pairs());
    }

    /** Of a search that has met all pairs, and no failure. */
    private Optional<Boolean> simulated() {
        boolean determined = packed == null ? pairs.isDetermined() : packed.isDetermined();
        if (determined && budget.takes(Shortcut.DETERMINED)) {
            return certain(true);
        }
        return packed == null || packed.size() <= MOST_SIMULATED
                ? simulation.verdict().flatMap(this::certain)
                : Optional.empty();
    }

    /** Who decides late about a message simulates more easily, and is less easily simulated. */
    private Optional<Boolean> certain(boolean simulates) {
        TransitionSystem late = simulates ? product.right : product.left;
        return late.postpones() ? Optional.empty() : Optional.of(simulates);
    }

    private void open() {
        Steps mine = product.left.openings();
        Steps theirs = product.right.openings();
        for (int step = 0; step < mine.size(); step++) {
            follow(Antichain.NONE, null, 0, mine, step, theirs, 0);
        }
    }

    private void expand(int node) {
        int left = pairs.left(node);
        int set = pairs.set(node);
        Alphabet alphabet = product.alphabet(left, set);
        Steps[] own = product.leftSteps(left, alphabet);
        for (int letter = 0; letter < own.length; letter++) {
            Steps mine = own[letter];
            Steps theirs = product.answers(set, alphabet, letter);
            tried++;
            int cost = pairs.cost(node) + alphabet.messages(letter);
            for (int step = 0; step < mine.size(); step++) {
                mine.use(step);
                follow(node, alphabet, letter, mine, step, theirs, cost);
            }
        }
    }

    /** One step of the left side, with all that the right side answers. */
    private void follow(
            int node,
            @Nullable Alphabet alphabet,
            int letter,
            Steps mine,
            int step,
            Steps theirs,
            int cost) {
        for (CubeSplit.Case sent : product.cases(mine.outputs()[step], theirs)) {
            int total = cost + sent.messages();
            if (sent.allowed().length == 0) {
                fail(new Failure(node, alphabet, letter, mine, step, sent, total, level));
            } else {
                add(node, mine.next()[step], product.successor(theirs, sent.allowed()), total);
            }
        }
    }

    private void fail(Failure failure) {
        best = better(best, failure);
        if (goesOn) {
            List<Trace.Cause> causes = failure.steps.causes().get(failure.step);
            failures.merge(new Kind(causes, failure.sent.error()), failure, TraceInclusion::better);
        }
    }

    /** The shorter one, then that with fewer messages, then the one that was found first. */
    private static Failure better(@Nullable Failure known, Failure found) {
        boolean cheaper = known != null && found.level == known.level && found.cost < known.cost;
        return known == null || cheaper ? found : known;
    }

    private void add(int parent, int left, int set, int cost) {
        if (set < 0) {
            chaosReached = true;
            return;
        }
        promising = promising || parent != Antichain.NONE && !product.isInChaos(set);
        long patience = Math.max(LITTLE_WORK, FACTOR * tried);
        boolean fresh = pairs.add(parent, left, set, cost, patience);
        chaosReached = chaosReached || fresh && product.isInChaos(set);
    }

    /** Why some inputs were left out that are told apart; empty where none was. */
    public Optional<String> missing() {
        return product.missing();
    }

    /**
     * Why it holds, of a search that found no failure: the clauses, or the pairs that show the
     * inclusion; empty where these are packed.
     */
    public Optional<Certificate> certificate() {
        return symbolic.proved()
                .map(engine -> Certificate.ofClauses(engine.clauses()))
                .or(() -> packed == null ? Optional.of(pairsMet()) : Optional.empty());
    }

    private Certificate pairsMet() {
        List<Certificate.Entry> entries = new ArrayList<>();
        for (int node = 0; node < pairs.size(); node++) {
            entries.add(entry(pairs.left(node), product.sets.members(pairs.set(node))));
        }
        simulation.forEachPair((left, right) -> entries.add(entry(left, right)));
        return new Certificate(entries.stream().distinct().toList());
    }

    private Certificate.Entry entry(int left, int... right) {
        return new Certificate.Entry(
                product.left.name(left),
                IntStream.of(right).mapToObj(product.right::name).toList());
    }

    /** A failure, told moment by moment. */
    public Counterexample counterexample(Failure failure) {
        return new Counterexample.Teller(product, pairs).tell(failure);
    }

    /** Parts and variables of the left side that the search did without. */
    public List<String> leftOut() {
        return leftOut;
    }

    /** Which parts of the left side are equal, so that the search did not tell their places. */
    public List<String> equalParts() {
        return packed == null ? List.of() : packed.equalParts();
    }

    /**
     * Of how many clauses the invariant is that shows the inclusion, where it was not the search
     * that did.
     */
    public Optional<Integer> invariant() {
        return symbolic.proved().map(SymbolicInclusion::size);
    }

    /** How many pairs were explored so far. */
    public long pairs() {
        return packed == null ? pairs.size() : packed.size();
    }

    /**
     * How many configurations of the left side were met so far; empty where counting them would
     * take too long.
     */
    public Optional<Integer> lefts() {
        return packed == null ? Optional.of(product.left.size()) : packed.lefts();
    }

    /** One failure for each cause of a forbidden step, the shortest. */
    public List<Failure> failures() {
        return List.copyOf(failures.values());
    }
}
