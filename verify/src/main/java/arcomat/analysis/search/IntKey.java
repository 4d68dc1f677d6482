package arcomat.analysis.search;

import java.util.Arrays;

/**
 * Integers as a key: equal to others that are the same in the same order.
 *
 * @param all not to be written to
 */
public record IntKey(int[] all) {
    private static final int GOLDEN = 0x9E3779B1;

    @Override
    public boolean equals(Object other) {
        return other instanceof IntKey key && Arrays.equals(all, key.all);
    }

    /** They are small: with a small factor, many of them together would collide. */
    @Override
    public int hashCode() {
        int hash = 0;
        for (int each : all) {
            hash = (hash + each) * GOLDEN;
        }
        return hash ^ hash >>> 15;
    }
}
