package arcomat.lower;

import arcomat.model.Value;
import arcomat.tree.TestSuite;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;

/**
 * Lays a stream out in slices: k {@code Tk} end k slices, and what stands behind the last one is
 * one slice more.
 */
final class StreamLayout {
    private final List<List<Value>> slices = new ArrayList<>();
    private List<Value> open = new ArrayList<>();

    private StreamLayout() {}

    /**
     * @param messages values of the messages in the order in which they are written, each once
     */
    static List<List<Value>> slices(List<TestSuite.StreamElement> elements, List<Value> messages) {
        StreamLayout layout = new StreamLayout();
        layout.add(elements, messages.iterator());
        if (!layout.open.isEmpty()) {
            layout.endSlice();
        }
        return layout.slices;
    }

    /** All messages of a stream in order, whatever slices they are in. */
    static List<Value> messages(List<TestSuite.StreamElement> elements, List<Value> messages) {
        List<Value> all = new ArrayList<>();
        slices(elements, messages).forEach(all::addAll);
        return all;
    }

    private void add(List<TestSuite.StreamElement> elements, Iterator<Value> messages) {
        TestSuite.StreamElement.Cases<Runnable> forms =
                new TestSuite.StreamElement.Cases<>(
                        tick -> this::endSlice,
                        message -> () -> open.add(messages.next()),
                        repeat -> () -> repeat(repeat, messages));
        elements.forEach(element -> element.match(forms).run());
    }

    private void repeat(TestSuite.Repeat repeat, Iterator<Value> messages) {
        List<Value> once = new ArrayList<>();
        for (int i = count(repeat.elements()); i > 0; i--) {
            once.add(messages.next());
        }
        for (int i = 0; i < repeat.count(); i++) {
            add(repeat.elements(), once.iterator());
        }
    }

    /** How many messages are written, repetitions not counted. */
    private static int count(List<TestSuite.StreamElement> elements) {
        int count = 0;
        for (TestSuite.StreamElement element : elements) {
            if (element instanceof TestSuite.Message) {
                count++;
            } else if (element instanceof TestSuite.Repeat repeat) {
                count += count(repeat.elements());
            }
        }
        return count;
    }

    private void endSlice() {
        slices.add(open.isEmpty() ? List.of() : List.copyOf(open));
        open = new ArrayList<>();
    }
}
