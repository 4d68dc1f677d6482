package arcomat.campaign.statistics;

import java.util.function.DoublePredicate;
import java.util.function.Supplier;
import java.util.stream.DoubleStream;

/**
 * A column of numbers that may be larger than memory: it is read from its beginning as often as it
 * takes. Infinity is a number like others, such as the time to a goal that was not reached; what is
 * not a number comes after it.
 */
public final class Measurements {
    /** A number's 64 bits are found out in four parts. */
    private static final int PART = 16;

    private final Supplier<DoubleStream> values;
    private final long size;

    private Measurements(Supplier<DoubleStream> values, long size) {
        this.values = values;
        this.size = size;
    }

    /**
     * Reads them once.
     *
     * @param values the same ones each time, in whatever order
     */
    public static Measurements of(Supplier<DoubleStream> values) {
        try (DoubleStream all = values.get()) {
            return new Measurements(values, all.count());
        }
    }

    /** How many there are. */
    public long size() {
        return size;
    }

    /** How many of them are so. */
    public Proportion share(DoublePredicate so) {
        try (DoubleStream all = values.get()) {
            return new Proportion(all.filter(so).count(), size);
        }
    }

    /**
     * The smallest number but for {@code rank - 1}; half a MB and four passes, however many there
     * are: each pass counts how many numbers begin in which way.
     *
     * @param rank from 1 to {@link #size}
     */
    double ranked(long rank) {
        if (rank < 1 || rank > size) {
            throw new IllegalArgumentException(rank + " of " + size);
        }
        long begin = 0;
        long left = rank;
        for (int shift = Long.SIZE - PART; shift >= 0; shift -= PART) {
            long[] counts = continuations(begin, shift);
            int next = 0;
            while (left > counts[next]) {
                left -= counts[next++];
            }
            begin = begin << PART | next;
        }
        return number(begin);
    }

    private long[] continuations(long begin, int shift) {
        long[] counts = new long[1 << PART];
        try (DoubleStream all = values.get()) {
            all.forEach(
                    value -> {
                        long bits = key(value) >>> shift;
                        if (bits >>> PART == begin) {
                            counts[(int) bits & (1 << PART) - 1]++;
                        }
                    });
        }
        return counts;
    }

    /**
     * Larger for a larger number, where neither has a sign: the bits of negative ones turn round.
     */
    private static long key(double value) {
        long bits = Double.doubleToLongBits(value);
        return bits < 0 ? ~bits : bits ^ Long.MIN_VALUE;
    }

    private static double number(long key) {
        return Double.longBitsToDouble(key < 0 ? key ^ Long.MIN_VALUE : ~key);
    }
}
