package arcomat.analysis.search.product;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.MacroStates;
import arcomat.analysis.search.packed.CheapestFailure;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.analysis.search.packed.PackedNetwork.TooNarrow;
import arcomat.analysis.search.packed.PackedTable;
import arcomat.analysis.search.packed.PairStore;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** Pairs in memory, as long as no set has several members. */
final class PackedPairs implements PairStore {
    private final PackedNetwork network;
    private PackedLayout layout;
    private PackedTable pairs;

    /** Configurations after steps that end the search: they are in no pair. */
    private PackedTable loose;

    /** Pairs that are added a little later: of many at once, the table finds the places sooner. */
    private long[] waitingKeys;

    private final int[] parentsOfWaiting = new int[PackedTable.MOST_TOUCHED];
    private final int[] costsOfWaiting = new int[PackedTable.MOST_TOUCHED];
    private int waiting;
    private final IntArrayList parents = new IntArrayList();

    private final Frontier frontier = new Frontier();
    private final CheapestFailure failure = new CheapestFailure();

    PackedPairs(PackedNetwork network, PackedLayout layout) {
        this.network = network;
        this.layout = layout;
        pairs = new PackedTable(layout.words());
        loose = new PackedTable(layout.words());
        waitingKeys = new long[layout.words() * PackedTable.MOST_TOUCHED];
    }

    @Override
    public void move(PackedLayout to) {
        addWaiting();
        pairs = pairs.moved(layout, to);
        loose = loose.moved(layout, to);
        waitingKeys = new long[to.words() * PackedTable.MOST_TOUCHED];
        layout = to;
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
    public void get(long[] into) {
        pairs.get(frontier.pair(), into);
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

    @Override
    public void addLoose(long[] key) {
        loose.add(key);
    }

    @Override
    public void fail(int parent, int cost) {
        failure.add(parent, cost);
    }

    @Override
    public CheapestFailure failure() {
        return failure;
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
        return frontier.nextLevel();
    }

    @Override
    public boolean next() {
        return frontier.next();
    }

    @Override
    public List<long[]> path() {
        List<long[]> path = new ArrayList<>();
        for (int node = (int) failure.pair(); node != NONE; node = parents.get(node)) {
            long[] key = new long[layout.words()];
            pairs.get(node, key);
            path.add(key);
        }
        Collections.reverse(path);
        return path;
    }

    @Override
    public PairStore amongSets(MacroStates sets, Budget budget) {
        addWaiting();
        PairsAmongSets all = new PairsAmongSets(network, layout, sets, budget, frontier, failure);
        long[] key = new long[layout.words()];
        for (int pair = 0; pair < pairs.size(); pair++) {
            pairs.get(pair, key);
            all.take(key, parents.get(pair));
        }
        for (int i = 0; i < loose.size(); i++) {
            loose.get(i, key);
            all.addLoose(key);
        }
        return all;
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
