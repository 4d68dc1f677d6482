package arcomat.analysis.search.product;

import com.carrotsearch.hppc.IntArrayList;

/**
 * The level of pairs that a search expands, those that took fewer messages first, and the one that
 * it finds meanwhile. Pairs are numbered from 0 as they are found.
 */
final class Frontier {
    /** Of the level that is expanded, and of the one that is found, from their first pair on. */
    private IntArrayList costs = new IntArrayList();

    private IntArrayList nextCosts = new IntArrayList();
    private int levelStart;
    private int nextStart;

    /** Positions in the costs of the level that is expanded. */
    private int[] level = new int[0];

    private int position = -1;

    /** A new pair has been found, after so many messages. */
    void add(int cost) {
        nextCosts.add(cost);
    }

    /** Whether a pair is of an earlier level than those that are being found. */
    boolean isOlder(int pair) {
        return pair < nextStart;
    }

    /** Of a pair of the level that is being found. */
    int costOfNext(int pair) {
        return nextCosts.get(pair - nextStart);
    }

    /** Whether a pair that is found again is one of this level and takes fewer messages now. */
    boolean cheapens(int pair, int cost) {
        if (isOlder(pair) || cost >= costOfNext(pair)) {
            return false;
        }
        nextCosts.set(pair - nextStart, cost);
        return true;
    }

    /** Goes on to the level that has been found; whether there is a pair in it. */
    boolean nextLevel() {
        costs = nextCosts;
        nextCosts = new IntArrayList();
        levelStart = nextStart;
        nextStart = levelStart + costs.size();
        level = byCost(costs, 0);
        position = -1;
        return level.length > 0;
    }

    /** Goes on to the next pair of the level that is expanded; whether there is one. */
    boolean next() {
        return ++position < level.length;
    }

    /** The pair that is expanded. */
    int pair() {
        return levelStart + level[position];
    }

    /** The messages on the way to it. */
    int cost() {
        return costs.get(level[position]);
    }

    /**
     * Positions, the least costs first, by counting; those that cost the same keep their order.
     *
     * @param from positions before that one are left out
     */
    static int[] byCost(IntArrayList costs, int from) {
        int least = Integer.MAX_VALUE;
        int most = Integer.MIN_VALUE;
        for (int i = from; i < costs.size(); i++) {
            least = Math.min(least, costs.get(i));
            most = Math.max(most, costs.get(i));
        }
        int count = costs.size() - from;
        int[] starts = new int[count == 0 ? 1 : most - least + 2];
        for (int i = from; i < costs.size(); i++) {
            starts[costs.get(i) - least + 1]++;
        }
        for (int i = 1; i < starts.length; i++) {
            starts[i] += starts[i - 1];
        }
        int[] sorted = new int[count];
        for (int i = from; i < costs.size(); i++) {
            sorted[starts[costs.get(i) - least]++] = i;
        }
        return sorted;
    }
}
