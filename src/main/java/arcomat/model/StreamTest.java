package arcomat.model;

import arcomat.source.Span;

import java.util.List;
import java.util.Map;

/**
 * A test with its streams laid out in slices.
 *
 * @param packageName of the suite; empty for the default package
 * @param arguments values of the component's parameters
 * @param inputs time-synchronous: one letter per slice; event-driven: one letter with one message
 *     per event
 * @param expected per checked output port, what it carries slice by slice (an empty list is
 *     silence). Time-synchronous: padded to the length of the test, with a further slice where
 *     outputs have delay 1. Event-driven: one list with all messages in order.
 */
public record StreamTest(
        String packageName,
        String suite,
        String name,
        Component component,
        List<Value> arguments,
        List<Letter> inputs,
        Map<String, List<List<Value>>> expected,
        Span span) {
    public StreamTest {
        arguments = List.copyOf(arguments);
        inputs = List.copyOf(inputs);
    }

    /** Of a suite in the default package. */
    public StreamTest(
            String suite,
            String name,
            Component component,
            List<Value> arguments,
            List<Letter> inputs,
            Map<String, List<List<Value>>> expected,
            Span span) {
        this("", suite, name, component, arguments, inputs, expected, span);
    }

    /** {@code shop.StopTest}. */
    public String qualifiedSuite() {
        return packageName.isEmpty() ? suite : packageName + "." + suite;
    }

    /** {@code shop.StopTest#stops}. */
    public String title() {
        return qualifiedSuite() + "#" + name;
    }

    /** The same with other expectations. */
    public StreamTest expecting(Map<String, List<List<Value>>> others) {
        return new StreamTest(packageName, suite, name, component, arguments, inputs, others, span);
    }
}
