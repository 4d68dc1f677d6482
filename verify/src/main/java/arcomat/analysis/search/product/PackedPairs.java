package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.MacroStates;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.analysis.search.packed.PackedNetwork.TooNarrow;
import arcomat.analysis.search.packed.PackedTable;
import arcomat.analysis.search.packed.PairStore;

/** Pairs in memory, as long as no set has several members. */
final class PackedPairs extends PairsInMemory {
    private PackedTable pairs;

    /** Pairs that are added a little later: of many at once, the table finds the places sooner. */
    private long[] waitingKeys;

    private final int[] parentsOfWaiting = new int[PackedTable.MOST_TOUCHED];
    private final int[] costsOfWaiting = new int[PackedTable.MOST_TOUCHED];
    private int waiting;

    PackedPairs(PackedNetwork network, PackedLayout layout) {
        super(network, layout);
        pairs = new PackedTable(layout.words());
        waitingKeys = new long[layout.words() * PackedTable.MOST_TOUCHED];
    }

    @Override
    public void move(PackedLayout to) {
        addWaiting();
        pairs = pairs.moved(layout, to);
        waitingKeys = new long[to.words() * PackedTable.MOST_TOUCHED];
        super.move(to);
    }

    @Override
    public long size() {
        return pairs.size();
    }

    @Override
    public void countBeyond(long most) {
        if (pairs.size() + waiting > most) {
            addWaiting();
        }
    }

    @Override
    void get(int pair, long[] into) {
        pairs.get(pair, into);
    }

    @Override
    public void add(long[] key, int parent, int set, int cost) {
        if (!layout.fits(network.markField(), set)) {
            throw new TooNarrow();
        }
        layout.put(key, network.markField(), set);
        if (waiting == parentsOfWaiting.length) {
            addWaiting();
        }
        System.arraycopy(key, 0, waitingKeys, waiting * key.length, key.length);
        parentsOfWaiting[waiting] = parent;
        costsOfWaiting[waiting++] = cost;
    }

    private void addWaiting() {
        pairs.touch(waitingKeys, waiting);
        for (int i = 0; i < waiting; i++) {
            add(i);
        }
        waiting = 0;
    }

    private void add(int which) {
        int cost = costsOfWaiting[which];
        int number = pairs.add(waitingKeys, which * layout.words());
        if (number < 0) {
            parents.add(parentsOfWaiting[which]);
            frontier.add(cost);
        } else if (frontier.cheapens(number, cost)) {
            parents.set(number, parentsOfWaiting[which]);
        }
    }

    @Override
    public boolean nextLevel() {
        addWaiting();
        return super.nextLevel();
    }

    @Override
    public PairStore amongSets(MacroStates sets, Budget budget) {
        addWaiting();
        return new PairsAmongSets(this, sets, budget);
    }

    @Override
    public int configurations(int sets) {
        if (sets <= 1 && loose.size() == 0) {
            return pairs.size();
        }
        long[] key = new long[layout.words()];
        PackedTable all = new PackedTable(layout.words());
        for (int node = 0; node < pairs.size(); node++) {
            pairs.get(node, key);
            layout.clear(key, network.markField());
            all.add(key);
        }
        for (int i = 0; i < loose.size(); i++) {
            loose.get(i, key);
            all.add(key);
        }
        return all.size();
    }

    @Override
    public void close() {
        addWaiting();
    }
}
