package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.MacroStates;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.analysis.search.packed.PackedNetwork.TooNarrow;
import arcomat.analysis.search.packed.PackedTable;

import com.carrotsearch.hppc.IntArrayList;

/**
 * Pairs in memory where the right side may be in several configurations at once: an antichain of
 * sets for each configuration of the left side. As in {@link Antichain}, a pair is left out where a
 * smaller set has been met with the same configuration, after fewer inputs, or after as many and no
 * more messages. Whether a member simulates the configuration is not asked.
 */
final class PairsAmongSets extends PairsInMemory {
    /** So many pairs are there in any case. */
    private static final int FEW = 10_000;

    /** Beyond them, so many sets for a configuration: more are a case for simulations. */
    private static final int MOST_SETS = 64;

    private final MacroStates macroStates;
    private final Budget budget;

    /** Configurations, without marks. */
    private PackedTable lefts;

    /** By configuration, the last of its pairs. */
    private final IntArrayList last = new IntArrayList();

    /** By pair: its configuration, its set, and the pair before it in the chain. */
    private final IntArrayList leftOf = new IntArrayList();

    private final IntArrayList setOf = new IntArrayList();
    private final IntArrayList previous = new IntArrayList();

    /**
     * @param before has met all pairs so far, none with several members
     */
    PairsAmongSets(PackedPairs before, MacroStates macroStates, Budget budget) {
        super(before);
        this.macroStates = macroStates;
        this.budget = budget;
        lefts = new PackedTable(layout.words());
        long[] key = new long[layout.words()];
        for (int pair = 0; pair < before.size(); pair++) {
            before.get(pair, key);
            int set = layout.get(key, network.markField());
            layout.clear(key, network.markField());
            chain(number(key), set);
        }
    }

    private int number(long[] key) {
        int number = lefts.add(key);
        if (number >= 0) {
            return number;
        }
        last.add(NONE);
        return ~number;
    }

    private void chain(int left, int set) {
        previous.add(last.get(left));
        last.set(left, leftOf.size());
        leftOf.add(left);
        setOf.add(set);
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
            chain(left, set);
            parents.add(parent);
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
    public void move(PackedLayout to) {
        lefts = lefts.moved(layout, to);
        super.move(to);
    }

    @Override
    public long size() {
        return leftOf.size();
    }

    @Override
    void get(int pair, long[] into) {
        lefts.get(leftOf.get(pair), into);
        layout.put(into, network.markField(), setOf.get(pair));
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
}
