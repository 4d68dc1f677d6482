package arcomat.analysis.search.product;

import arcomat.analysis.search.packed.CheapestFailure;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.analysis.search.packed.PackedTable;
import arcomat.analysis.search.packed.PairStore;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** What pairs in memory have in common, whatever finds them again: levels, and the way to each. */
abstract class PairsInMemory implements PairStore {
    final PackedNetwork network;
    PackedLayout layout;

    /** Configurations after steps that end the search: they need be in no pair. */
    PackedTable loose;

    /** By pair, the one before it. */
    final IntArrayList parents;

    final Frontier frontier;
    private final CheapestFailure failure;

    /** None so far. */
    PairsInMemory(PackedNetwork network, PackedLayout layout) {
        this.network = network;
        this.layout = layout;
        loose = new PackedTable(layout.words());
        parents = new IntArrayList();
        frontier = new Frontier();
        failure = new CheapestFailure();
    }

    /** Those of another one, which are found here from now on. */
    PairsInMemory(PairsInMemory before) {
        network = before.network;
        layout = before.layout;
        loose = before.loose;
        parents = before.parents;
        frontier = before.frontier;
        failure = before.failure;
    }

    /** Writes the key of a pair down, with its mark. */
    abstract void get(int pair, long[] into);

    @Override
    public final void get(long[] into) {
        get(frontier.pair(), into);
    }

    @Override
    public final int node() {
        return frontier.pair();
    }

    @Override
    public final int cost() {
        return frontier.cost();
    }

    @Override
    public final void addLoose(long[] key) {
        loose.add(key);
    }

    @Override
    public final void fail(int parent, int cost) {
        failure.add(parent, cost);
    }

    @Override
    public final CheapestFailure failure() {
        return failure;
    }

    @Override
    public void move(PackedLayout to) {
        loose = loose.moved(layout, to);
        layout = to;
    }

    @Override
    public boolean nextLevel() {
        return frontier.nextLevel();
    }

    @Override
    public final boolean next() {
        return frontier.next();
    }

    @Override
    public final List<long[]> path() {
        List<long[]> path = new ArrayList<>();
        for (int pair = (int) failure.pair(); pair != NONE; pair = parents.get(pair)) {
            long[] key = new long[layout.words()];
            get(pair, key);
            path.add(key);
        }
        Collections.reverse(path);
        return path;
    }
}
