package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.composition.GlobalState;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.analysis.search.packed.PackedNetwork.TooNarrow;
import arcomat.analysis.search.packed.PackedSteps;
import arcomat.analysis.search.packed.PairStore;
import arcomat.analysis.search.product.PackedAnswers.Answer;
import arcomat.analysis.search.product.PackedAnswers.Frame;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.PackableSystem;
import arcomat.semantics.value.GivenUp;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * The search of {@link TraceInclusion} where the left side is a network whose configurations are
 * packed. It meets the same pairs in the same order, but that it leaves none out since a member of
 * a set simulates a configuration; of pairs that differ in the places of equal parts it meets one
 * that stands for them.
 */
final class PackedInclusion {
    /**
     * What was found.
     *
     * @param path the pairs that lead to the first failure, for {@link #isAt}; empty where there is
     *     none
     * @param cost how many messages the failure takes
     */
    record Found(
            List<long[]> path,
            int cost,
            Optional<String> stopped,
            boolean chaosReached,
            boolean promising) {}

    private final Product product;
    private final PackableSystem left;
    private final PackedNetwork network;
    private final Budget budget;
    private final SymbolicTurns symbolic;
    private final PackedAnswers answers;
    private PairStore pairs;
    private boolean determined = true;
    private PackedLayout layout;
    private PackedSteps steps;

    /** Gives the configuration that stands for one. */
    private Consumer<long[]> canonical;

    private long[] configuration;
    private long[] key;

    private PackedInclusion(
            Product product,
            PackableSystem left,
            Budget budget,
            SymbolicTurns symbolic,
            PairStore.Maker stores) {
        this.product = product;
        this.left = left;
        this.budget = budget;
        this.symbolic = symbolic;
        network = left.packed();
        answers = new PackedAnswers(product, left, network, this::amongSets);
        layout = network.layout();
        steps = network.steps(layout);
        canonical = network.canonical(layout);
        pairs = stores.of(network, layout);
        configuration = new long[layout.words()];
        key = new long[layout.words()];
    }

    /** Whether it is worth a try. */
    static boolean isFor(Product product) {
        return product.left instanceof PackableSystem network
                && network.canBePacked()
                && !product.hasFreeData();
    }

    /**
     * Ready to search; empty where that is not possible.
     *
     * @param symbolic asked beside the search
     * @param stores makes the place for pairs
     */
    static Optional<PackedInclusion> of(
            Product product, Budget budget, SymbolicTurns symbolic, PairStore.Maker stores) {
        if (!isFor(product)) {
            return Optional.empty();
        }
        try {
            PackableSystem network = (PackableSystem) product.left;
            return Optional.of(new PackedInclusion(product, network, budget, symbolic, stores));
        } catch (CannotPack unfit) {
            return Optional.empty();
        }
    }

    private void amongSets() {
        determined = false;
        pairs = pairs.amongSets(product.sets, budget);
    }

    /** Empty where only the unpacked search can tell. */
    Optional<Found> run() {
        try {
            if (!open()) {
                return Optional.empty();
            }
            PackedLayout before = pairs.resume(() -> widening(this::expand));
            if (before != null) {
                use(before);
            }
            return Optional.of(levels());
        } catch (CannotPack unfit) {
            return Optional.empty();
        } catch (GivenUp inTheMiddle) {
            pairs.close();
            throw inTheMiddle;
        }
    }

    /** In words, which parts are equal, so that their places did not matter. */
    List<String> equalParts() {
        return network.equalParts();
    }

    /** Whether every set that was met has one member. */
    boolean isDetermined() {
        return determined;
    }

    /** How many pairs have been met. */
    long size() {
        return pairs.size();
    }

    /** How many configurations of the left side have been met; empty where that was given up. */
    Optional<Integer> lefts() {
        return Budget.within(
                () -> Optional.of(pairs.configurations(answers.sets())), why -> Optional.empty());
    }

    /** Goes on in a layout for all that has been met. */
    private void widen() {
        PackedLayout wider = network.layout();
        pairs.move(wider);
        use(wider);
    }

    private void use(PackedLayout other) {
        layout = other;
        steps = network.steps(layout);
        canonical = network.canonical(layout);
        answers.forgetShown();
        configuration = new long[layout.words()];
        key = new long[layout.words()];
    }

    private void widening(Runnable action) {
        while (true) {
            try {
                action.run();
                return;
            } catch (TooNarrow more) {
                widen();
            }
        }
    }

    /** Whether every beginning is allowed. */
    private boolean open() {
        Steps mine = left.openings();
        Steps theirs = product.right.openings();
        for (int step = 0; step < mine.size(); step++) {
            Answer answer = answers.atTheStart(mine.outputs()[step], theirs);
            int next = mine.next()[step];
            for (int i = 0; i < answer.next().length; i++) {
                int set = answer.next()[i];
                int cost = answer.messages()[i];
                if (set == PackedAnswers.FAILS) {
                    return false;
                }
                widening(() -> begin(next, set, cost));
            }
        }
        return true;
    }

    private void begin(int next, int set, int cost) {
        network.pack(left.state(next), layout, key);
        canonical.accept(key);
        reach(PairStore.NONE, set, cost);
    }

    private Found levels() {
        do {
            while (pairs.next()) {
                @Nullable String exhausted = exhausted();
                if (exhausted != null) {
                    boolean proved =
                            !pairs.failure().isFound() && symbolic.proveAlone(pairs.size());
                    return found(proved ? Optional.empty() : Optional.of(exhausted));
                }
                visit();
                if (!pairs.failure().isFound() && symbolic.prove(pairs.size())) {
                    return found(Optional.empty());
                }
            }
        } while (!pairs.failure().isFound() && pairs.nextLevel());
        return found(Optional.empty());
    }

    private void visit() {
        int known = computed();
        try {
            widening(this::expand);
        } finally {
            if (computed() != known) {
                pairs.learn();
            }
        }
    }

    private int computed() {
        return network.computed() + answers.computed();
    }

    private @Nullable String exhausted() {
        pairs.countBeyond(budget.states());
        return budget.exhausted(pairs.size());
    }

    private Found found(Optional<String> stopped) {
        pairs.close();
        return new Found(
                pairs.path(),
                pairs.failure().cost(),
                stopped,
                answers.chaosReached(),
                answers.promising());
    }

    /** Whether a configuration and a set are a pair that has been met. */
    boolean isAt(long[] pair, GlobalState state, int set) {
        if (layout.get(pair, network.markField()) != set) {
            return false;
        }
        try {
            network.pack(state, layout, key);
            canonical.accept(key);
        } catch (TooNarrow | CannotPack other) {
            return false;
        }
        layout.put(key, network.markField(), set);
        return Arrays.equals(key, pair);
    }

    private void expand() {
        pairs.get(configuration);
        int node = pairs.node();
        int set = layout.get(configuration, network.markField());
        layout.clear(configuration, network.markField());
        if (network.hasEnded(configuration, layout)) {
            return;
        }
        steps.begin(configuration);
        Frame frame = answers.frame(set, steps.looks(), this::number);
        int cost = pairs.cost();
        for (int letter = 0; letter < frame.messages.length; letter++) {
            steps.read(frame.messages[letter]);
            int more = cost + frame.cost(letter);
            while (steps.next()) {
                follow(node, frame, letter, more);
            }
        }
    }

    /** That of the configuration that is expanded. */
    private int number() {
        return left.configuration(network.unpack(configuration, layout));
    }

    private void follow(int node, Frame frame, int letter, int cost) {
        int sent = steps.hasEnded() ? OutputCubes.ERROR : answers.sent(steps, steps.shown());
        Answer answer = answers.answer(frame, letter, sent);
        for (int i = 0; i < answer.next().length; i++) {
            int next = answer.next()[i];
            int total = cost + answer.messages()[i];
            steps.after(key);
            canonical.accept(key);
            reach(node, next, total);
            if (next == PackedAnswers.FAILS) {
                pairs.fail(node, total);
            }
        }
    }

    /** What is in {@link #key} is reached, together with a set where there is one. */
    private void reach(int parent, int set, int cost) {
        if (set < 0) {
            pairs.addLoose(key);
        } else {
            pairs.add(key, parent, set, cost);
        }
    }
}
