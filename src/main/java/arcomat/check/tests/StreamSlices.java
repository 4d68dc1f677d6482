package arcomat.check.tests;

import arcomat.tree.TestSuite;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * What a piece of a stream has at its two ends, so that pieces can be joined without being laid
 * out.
 *
 * @param opening the first message before the first tick
 * @param closing the last message behind the last tick
 * @param ticks whether a slice ends in the piece
 */
record StreamSlices(
        Optional<TestSuite.Message> opening, Optional<TestSuite.Message> closing, boolean ticks) {
    private static final StreamSlices EMPTY =
            new StreamSlices(Optional.empty(), Optional.empty(), false);

    /**
     * Reads a stream and hands out each message that comes second in its slice; a message that is
     * repeated may be handed out twice.
     */
    static StreamSlices read(
            List<TestSuite.StreamElement> elements, Consumer<TestSuite.Message> second) {
        TestSuite.StreamElement.Cases<StreamSlices> forms =
                new TestSuite.StreamElement.Cases<>(
                        tick -> new StreamSlices(Optional.empty(), Optional.empty(), true),
                        message ->
                                new StreamSlices(Optional.of(message), Optional.of(message), false),
                        repeat -> repeated(repeat, second));
        StreamSlices all = EMPTY;
        for (TestSuite.StreamElement element : elements) {
            all = all.join(element.match(forms), second);
        }
        return all;
    }

    private static StreamSlices repeated(
            TestSuite.Repeat repeat, Consumer<TestSuite.Message> second) {
        StreamSlices once = read(repeat.elements(), second);
        return repeat.count() > 1 ? once.join(once, second) : once;
    }

    private StreamSlices join(StreamSlices next, Consumer<TestSuite.Message> second) {
        if (closing.isPresent()) {
            next.opening.ifPresent(second);
        }
        return new StreamSlices(
                ticks ? opening : opening.or(() -> next.opening),
                next.ticks ? next.closing : next.closing.or(() -> closing),
                ticks || next.ticks);
    }
}
