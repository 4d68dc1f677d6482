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

    /** So many numbers that begin alike are sorted: 8 MB. */
    private static final int SORTED = 1 << 20;

    private final Supplier<DoubleStream> values;
    private final long size;
    private final int sorted;

    private Measurements(Supplier<DoubleStream> values, long size, int sorted) {
        this.values = values;
        this.size = size;
        this.sorted = sorted;
    }

    /**
     * Reads them once.
     *
     * @param values the same ones each time, in whatever order
     */
    public static Measurements of(Supplier<DoubleStream> values) {
        return of(values, SORTED);
    }

    /**
     * @param sorted how many may be in memory at once
     */
    static Measurements of(Supplier<DoubleStream> values, int sorted) {
        try (DoubleStream all = values.get()) {
            return new Measurements(values, all.count(), sorted);
        }
    }

    /** How many there are. */
    public long size() {
        return size;
    }

    /** These, and so many more that are all the same. */
    public Measurements with(double value, long times) {
        Supplier<DoubleStream> all =
                () ->
                        DoubleStream.concat(
                                values.get(), DoubleStream.generate(() -> value).limit(times));
        return times == 0 ? this : new Measurements(all, size + times, sorted);
    }

    /** How many of them are so. */
    public Proportion share(DoublePredicate so) {
        try (DoubleStream all = values.get()) {
            return new Proportion(all.filter(so).count(), size);
        }
    }

    /** The smallest of them, of which there is at least one. */
    public double least() {
        return ranked(1);
    }

    /** The greatest of them, of which there is at least one. */
    public double greatest() {
        return ranked(size);
    }

    /**
     * The smallest number but for {@code rank - 1}. Each pass counts in which ways numbers go on
     * that begin like it, until they are few enough to be sorted: two passes for some ten million
     * numbers, five and a MB however many there are.
     *
     * @param rank from 1 to {@link #size}
     */
    double ranked(long rank) {
        if (rank < 1 || rank > size) {
            throw new IllegalArgumentException(rank + " of " + size);
        }
        Beginning beginning = new Beginning(0, 0);
        long left = rank;
        long alike = size;
        while (alike > sorted && !beginning.isWhole()) {
            long[] counts = continuations(beginning);
            int next = 0;
            while (left > counts[next]) {
                left -= counts[next++];
            }
            beginning = beginning.with(next);
            alike = counts[next];
        }
        return beginning.isWhole() ? beginning.number() : sorted(beginning)[(int) left - 1];
    }

    private long[] continuations(Beginning beginning) {
        long[] counts = new long[1 << PART];
        try (DoubleStream all = values.get()) {
            all.filter(beginning::isOf).forEach(value -> counts[beginning.next(value)]++);
        }
        return counts;
    }

    private double[] sorted(Beginning beginning) {
        try (DoubleStream all = values.get()) {
            return all.filter(beginning::isOf).sorted().toArray();
        }
    }

    /** The first {@code length} bits of a number, of a key that is larger for a larger number. */
    private record Beginning(long bits, int length) {
        boolean isOf(double value) {
            return length == 0 || key(value) >>> Long.SIZE - length == bits;
        }

        int next(double value) {
            return (int) (key(value) >>> Long.SIZE - length - PART) & (1 << PART) - 1;
        }

        Beginning with(int next) {
            return new Beginning(bits << PART | next, length + PART);
        }

        boolean isWhole() {
            return length == Long.SIZE;
        }

        double number() {
            return Double.longBitsToDouble(bits < 0 ? bits ^ Long.MIN_VALUE : ~bits);
        }

        /** Without a sign; the bits of negative numbers turn round. */
        private static long key(double value) {
            long bits = Double.doubleToLongBits(value);
            return bits < 0 ? ~bits : bits ^ Long.MIN_VALUE;
        }
    }
}
