package arcomat.analysis.search.external;

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

    /** The last block that does not begin behind a key: ever longer steps, then halves of them. */
    private int block(long[] key) {
        int below = loaded;
        int step = 1;
        while (below + step < run.blocks() && run.compareToFirst(key, below + step) >= 0) {
            below += step;
            step *= 2;
        }
        int above = Math.min(below + step, run.blocks());
        while (above - below > 1) {
            int middle = below + above >>> 1;
            if (run.compareToFirst(key, middle) >= 0) {
                below = middle;
            } else {
                above = middle;
            }
        }
        return below;
    }

    /** Goes on to the first record that is not before a key. */
    private void advance(long[] key) {
        int below = position - 1;
        int step = 1;
        while (below + step < count && compare(key, below + step) > 0) {
            below += step;
            step *= 2;
        }
        int above = Math.min(below + step, count);
        while (above - below > 1) {
            int middle = below + above >>> 1;
            if (compare(key, middle) > 0) {
                below = middle;
            } else {
                above = middle;
            }
        }
        position = above;
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
