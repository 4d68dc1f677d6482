package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.MacroStates;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.packed.CheapestFailure;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.analysis.search.packed.PackedNetwork.TooNarrow;
import arcomat.analysis.search.packed.PackedTable;
import arcomat.analysis.search.packed.PairStore;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Pairs in memory where the right side may be in several configurations at once: an antichain of
 * sets for each configuration of the left side. As in {@link Antichain}, a pair is left out where a
 * smaller set has been met with the same configuration, after fewer inputs, or after as many and no
 * more messages. Whether a member simulates the configuration is not asked.
 */
final class PairsAmongSets implements PairStore {
    /** So many pairs are there in any case. */
    private static final int FEW = 10_000;

    /** Beyond them, so many sets for a configuration: more are a case for simulations. */
    private static final int MOST_SETS = 64;

    private final PackedNetwork network;
    private final MacroStates macroStates;
    private final Budget budget;
    private final Frontier frontier;
    private final CheapestFailure failure;
    private PackedLayout layout;

    /** Configurations, without marks. */
    private PackedTable lefts;

    /** Of them, those that only steps reach that end the search. */
    private PackedTable loose;

    /** By configuration, the last of its pairs. */
    private final IntArrayList last = new IntArrayList();

    /** By pair: its configuration, its set, the pair before it on the way, and in the chain. */
    private final IntArrayList leftOf = new IntArrayList();

    private final IntArrayList setOf = new IntArrayList();
    private final IntArrayList parents = new IntArrayList();
    private final IntArrayList previous = new IntArrayList();

    /**
     * @param frontier whose pairs are going to be taken over
     * @param failure that has been found so far
     */
    PairsAmongSets(
            PackedNetwork network,
            PackedLayout layout,
            MacroStates macroStates,
            Budget budget,
            Frontier frontier,
            CheapestFailure failure) {
        this.network = network;
        this.layout = layout;
        this.macroStates = macroStates;
        this.budget = budget;
        this.frontier = frontier;
        this.failure = failure;
        lefts = new PackedTable(layout.words());
        loose = new PackedTable(layout.words());
    }

    /**
     * Takes over a pair that the frontier knows, as the next one.
     *
     * @param key with its mark, which is taken away
     */
    void take(long[] key, int parent) {
        int set = layout.get(key, network.markField());
        layout.clear(key, network.markField());
        append(number(key), set, parent);
    }

    private int number(long[] key) {
        int number = lefts.add(key);
        if (number >= 0) {
            return number;
        }
        last.add(NONE);
        return ~number;
    }

    private void append(int left, int set, int parent) {
        previous.add(last.get(left));
        last.set(left, leftOf.size());
        leftOf.add(left);
        setOf.add(set);
        parents.add(parent);
    }

    @Override
    public void add(long[] key, int parent, int set, int cost) {
        if (!layout.fits(network.markField(), set)) {
            throw new TooNarrow();
        }
        int left = number(key);
        int known = pair(left, set);
        if (known != NONE) {
            if (frontier.cheapens(known, cost)) {
                parents.set(known, parent);
            }
        } else if (!isCovered(left, set, cost)) {
            insistOnFew();
            append(left, set, parent);
            frontier.add(cost);
        }
    }

    private int pair(int left, int set) {
        int pair = last.get(left);
        while (pair != NONE && setOf.get(pair) != set) {
            pair = previous.get(pair);
        }
        return pair;
    }

    private void insistOnFew() {
        if (size() > FEW && size() / MOST_SETS > lefts.size()) {
            throw new CannotPack("the right side may be in too many sets of configurations");
        }
    }

    private boolean isCovered(int left, int set, int cost) {
        for (int pair = last.get(left); pair != NONE; pair = previous.get(pair)) {
            if (covers(pair, set, cost) && budget.takes(rule(setOf.get(pair)))) {
                return true;
            }
        }
        return false;
    }

    private Shortcut rule(int smaller) {
        boolean alone = macroStates.members(smaller).length == 1;
        return alone ? Shortcut.MET_ALONE : Shortcut.MET_SMALLER;
    }

    /** Whether what fails behind a larger set is found behind this pair, and as soon. */
    private boolean covers(int pair, int set, int cost) {
        return macroStates.isSubset(setOf.get(pair), set)
                && (frontier.isOlder(pair) || frontier.costOfNext(pair) <= cost);
    }

    @Override
    public void addLoose(long[] key) {
        loose.add(key);
    }

    @Override
    public void move(PackedLayout to) {
        lefts = lefts.moved(layout, to);
        loose = loose.moved(layout, to);
        layout = to;
    }

    @Override
    public long size() {
        return leftOf.size();
    }

    @Override
    public void countBeyond(long most) {}

    @Override
    public void fail(int parent, int cost) {
        failure.add(parent, cost);
    }

    @Override
    public CheapestFailure failure() {
        return failure;
    }

    @Override
    public boolean nextLevel() {
        return frontier.nextLevel();
    }

    @Override
    public boolean next() {
        return frontier.next();
    }

    @Override
    public int node() {
        return frontier.pair();
    }

    @Override
    public int cost() {
        return frontier.cost();
    }

    @Override
    public void get(long[] into) {
        get(frontier.pair(), into);
    }

    private void get(int pair, long[] into) {
        lefts.get(leftOf.get(pair), into);
        layout.put(into, network.markField(), setOf.get(pair));
    }

    @Override
    public List<long[]> path() {
        List<long[]> path = new ArrayList<>();
        for (int pair = (int) failure.pair(); pair != NONE; pair = parents.get(pair)) {
            long[] key = new long[layout.words()];
            get(pair, key);
            path.add(key);
        }
        Collections.reverse(path);
        return path;
    }

    @Override
    public int configurations(int sets) {
        int others = 0;
        long[] key = new long[layout.words()];
        for (int i = 0; i < loose.size(); i++) {
            loose.get(i, key);
            others += lefts.find(key) < 0 ? 1 : 0;
        }
        return lefts.size() + others;
    }

    @Override
    public void close() {}
}
