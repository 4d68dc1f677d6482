package arcomat.analysis.search.packed;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.MacroStates;

import org.jspecify.annotations.Nullable;

import java.util.List;

/**
 * The pairs that a packed search has met, level by level, each with the pair before it and the
 * messages that it took. A pair is a packed configuration with the number of a set as its mark.
 */
public interface PairStore {
    /** In place of a pair, before a beginning. */
    int NONE = -1;

    /** Where a search keeps its pairs. */
    interface Maker {
        PairStore of(PackedNetwork network, PackedLayout layout);
    }

    /** The same pairs in another layout. */
    void move(PackedLayout to);

    /** How many there are, but for those that wait. */
    long size();

    /** Nobody waits where there may be more than so many. */
    default void countBeyond(long most) {}

    /**
     * A configuration is reached, together with a set.
     *
     * @param key the configuration; marked here
     * @param parent the pair before it, of the level that is expanded
     */
    void add(long[] key, int parent, int set, int cost);

    /** A configuration is reached where the right side does not matter any more. */
    void addLoose(long[] key);

    /** A step from a pair of the level that is expanded fails; the first of the cheapest counts. */
    void fail(int parent, int cost);

    CheapestFailure failure();

    /** Goes on to the level that has been found; whether there is a pair in it. */
    boolean nextLevel();

    /**
     * Goes on to the next pair of the level, those that took fewer messages first; whether there is
     * one.
     */
    boolean next();

    /** A name of that pair. */
    int node();

    /** The messages on the way to it. */
    int cost();

    void get(long[] into);

    /** The pairs that lead to the failure, a beginning first; empty where there is none. */
    List<long[]> path();

    /**
     * How many configurations have been met, whatever the set beside them. May be given up, as long
     * steps are.
     */
    int configurations(int sets);

    /**
     * The same pairs, where from now on the right side may be in several configurations at once. A
     * pair may be left out there whose set has a smaller one beside it. May be told again.
     *
     * @param budget asked whether it may
     */
    default PairStore amongSets(MacroStates sets, Budget budget) {
        return this;
    }

    /** After the last step of a search. */
    default void close() {}

    /** What was not known before has been computed to expand the pair. */
    default void learn() {}

    /**
     * Goes on with a search that was begun earlier.
     *
     * @param expand expands a pair again, so that its numbers are given again
     * @return the layout of its pairs; null where nothing was begun
     */
    default @Nullable PackedLayout resume(Runnable expand) {
        return null;
    }
}
