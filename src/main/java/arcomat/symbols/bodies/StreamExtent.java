package arcomat.symbols.bodies;

import arcomat.tree.TestSuite;

import java.util.List;

/**
 * How long a stream is once its repetitions are written out; numbers stop at {@link #ENDLESS}.
 *
 * @param ticks ends of slices
 * @param messages in all slices
 */
public record StreamExtent(long ticks, long messages) {
    /** More slices and messages than this in one test are refused. */
    public static final long LIMIT = 200_000;

    private static final long ENDLESS = Long.MAX_VALUE / 4;

    static StreamExtent of(List<TestSuite.StreamElement> elements) {
        long ticks = 0;
        long messages = 0;
        for (TestSuite.StreamElement element : elements) {
            if (element instanceof TestSuite.Tick) {
                ticks = sum(ticks, 1);
            } else if (element instanceof TestSuite.Message) {
                messages = sum(messages, 1);
            } else if (element instanceof TestSuite.Repeat repeat) {
                StreamExtent inner = of(repeat.elements());
                ticks = sum(ticks, product(repeat.count(), inner.ticks));
                messages = sum(messages, product(repeat.count(), inner.messages));
            }
        }
        return new StreamExtent(ticks, messages);
    }

    static long sum(long a, long b) {
        return Math.min(ENDLESS, a + b);
    }

    private static long product(long a, long b) {
        return a <= 0 || b == 0 ? 0 : a > ENDLESS / b ? ENDLESS : a * b;
    }

    public long total() {
        return sum(ticks, messages);
    }
}
