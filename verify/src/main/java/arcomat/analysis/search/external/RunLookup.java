package arcomat.analysis.search.external;

import java.util.function.IntPredicate;

/**
 * Whether keys are in a sorted run. They are asked for in the same order, so that each block is
 * read once, and none in which no key can be.
 */
final class RunLookup {
    private final Records run;
    private final long[] block;
    private int loaded = -1;
    private int position;
    private int count;

    RunLookup(Records run) {
        this.run = run;
        block = run.block();
    }

    boolean contains(long[] key) {
        int wanted = block(key);
        if (wanted < 0) {
            return false;
        }
        if (wanted != loaded) {
            run.read(wanted, block);
            loaded = wanted;
            position = 0;
            count = run.inBlock(wanted);
        }
        advance(key);
        return position < count && compare(key, position) == 0;
    }

    /** The last block that does not begin behind a key. */
    private int block(long[] key) {
        return last(loaded, run.blocks(), block -> run.compareToFirst(key, block) >= 0);
    }

    /** Goes on to the first record that is not before a key. */
    private void advance(long[] key) {
        position = 1 + last(position - 1, count, record -> compare(key, record) > 0);
    }

    /**
     * The last one of which something is so, as it is of all before it: found by ever longer steps,
     * and then by halves of them.
     */
    private static int last(int known, int end, IntPredicate isSo) {
        int below = known;
        int step = 1;
        while (below + step < end && isSo.test(below + step)) {
            below += step;
            step *= 2;
        }
        int above = Math.min(below + step, end);
        while (above - below > 1) {
            int middle = below + above >>> 1;
            if (isSo.test(middle)) {
                below = middle;
            } else {
                above = middle;
            }
        }
        return below;
    }

    private int compare(long[] key, int record) {
        int start = record * run.width;
        for (int word = key.length - 1; word >= 0; word--) {
            int comparison = Long.compareUnsigned(key[word], block[start + word]);
            if (comparison != 0) {
                return comparison;
            }
        }
        return 0;
    }
}
