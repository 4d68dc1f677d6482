package arcomat.rt;

/**
 * Where a model leaves something open, this decides: a small generator of random numbers in 32-bit
 * arithmetic. Interpreter and generated code draw from it in the same order, so that one seed means
 * one run everywhere. The sequence is part of the product: a recorded seed stays valid.
 *
 * <p>Marsaglia's xorshift with the shifts 13, 17, 5 (Journal of Statistical Software 8, 2003), all
 * 2^32 - 1 states but 0; the seed is spread by one multiplication, so that neighbouring seeds part
 * at once.
 */
public final class Choice {
    private int state;

    public Choice(int seed) {
        int spread = (seed ^ 0x2545F491) * 0x9E3779B1;
        spread ^= spread >>> 15;
        state = spread == 0 ? 1 : spread;
    }

    /**
     * The next number.
     *
     * @param bound at least 1
     * @return 0 to bound - 1
     */
    public int next(int bound) {
        state ^= state << 13;
        state ^= state >>> 17;
        state ^= state << 5;
        return (int) (((state & 0xFFFFFFFFL) * bound) >>> 32);
    }

    /**
     * One of the members of a set, drawn only where there are several.
     *
     * @param set a bit per member
     * @return the position of the bit; -1 for the empty set
     */
    public int among(int set) {
        return among(set & 0xFFFFFFFFL);
    }

    /** Like {@link #among(int)}, for larger sets. */
    public int among(long set) {
        int count = 0;
        for (long rest = set; rest != 0; rest &= rest - 1) {
            count++;
        }
        int skipped = count > 1 ? next(count) : 0;
        for (int position = 0; position < 64; position++) {
            if ((set >>> position & 1) != 0 && skipped-- == 0) {
                return position;
            }
        }
        return -1;
    }
}
