package arcomat.symbols.bodies;

import arcomat.tree.TestSuite;

import java.util.List;
import java.util.stream.Stream;

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

    private static final TestSuite.StreamElement.Cases<StreamExtent> FORMS =
            new TestSuite.StreamElement.Cases<>(
                    tick -> new StreamExtent(1, 0),
                    message -> new StreamExtent(0, 1),
                    repeat -> of(repeat.elements()).times(repeat.count()));

    static StreamExtent of(List<TestSuite.StreamElement> elements) {
        return sum(elements.stream().map(element -> element.match(FORMS)));
    }

    private StreamExtent times(int count) {
        return new StreamExtent(product(count, ticks), product(count, messages));
    }

    /** Of several streams together. */
    static StreamExtent sum(Stream<StreamExtent> extents) {
        return extents.reduce(
                new StreamExtent(0, 0),
                (a, b) -> new StreamExtent(sum(a.ticks, b.ticks), sum(a.messages, b.messages)));
    }

    private static long sum(long a, long b) {
        return Math.min(ENDLESS, a + b);
    }

    private static long product(long a, long b) {
        return a <= 0 || b == 0 ? 0 : a > ENDLESS / b ? ENDLESS : a * b;
    }

    public long total() {
        return sum(ticks, messages);
    }
}
