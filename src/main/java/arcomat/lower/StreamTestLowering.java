package arcomat.lower;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Parameter;
import arcomat.model.StreamTest;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.Delays;
import arcomat.symbols.bodies.InstancePath;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.StreamTestSymbol.StreamSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.names.TypeSubstitution;
import arcomat.tree.Name;
import arcomat.tree.TestSuite;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * Stream tests, laid out in slices or as a sequence of events.
 *
 * <p>A test is as long as its longest input, or as what is expected asks for: an output with delay
 * 1 shows the reaction to n slices of input in n + 1 slices, so its stream asks for one slice of
 * input less than it has. Every stream is then padded with silence to that length, the expected
 * ones of outputs with delay 1 to one slice more.
 */
final class StreamTestLowering {
    private final ComponentLowering components;
    private final Delays delays;
    private final TestSuiteSymbol suite;
    private final Environment fields;
    private final ExpressionLowering expressions;

    StreamTestLowering(ComponentLowering components, Delays delays, TestSuiteSymbol suite) {
        this.components = components;
        this.delays = delays;
        this.suite = suite;
        Environment nowhere = Environment.of(TypeSubstitution.NONE);
        this.fields = nowhere.withVariables(VariableLowering.lower(suite.fields(), nowhere));
        this.expressions = new ExpressionLowering(fields);
    }

    List<StreamTest> lower() {
        ComponentSymbol symbol = Lowering.resolved(suite.component(), suite.node().component());
        Instantiation instantiation = Instantiation.plain(symbol);
        Component component = components.lower(instantiation);
        List<Value> arguments = arguments(instantiation, component.parameters());
        List<StreamTest> tests = new ArrayList<>();
        for (StreamTestSymbol test : suite.tests()) {
            Streams streams =
                    symbol.isEventDriven() ? eventDriven(test) : timeSynchronous(symbol, test);
            tests.add(
                    new StreamTest(
                            suite.unit().packageText(),
                            suite.name(),
                            test.name(),
                            component,
                            arguments,
                            streams.driven(),
                            Collections.unmodifiableMap(streams.expected()),
                            test.node().span()));
        }
        return tests;
    }

    /** What drives a component, letter by letter, and what is expected of it by port and slice. */
    private record Streams(List<Letter> driven, Map<String, List<List<Value>>> expected) {}

    private List<Value> arguments(Instantiation instantiation, List<Parameter> parameters) {
        return ArgumentLowering.lower(
                        suite.arguments(),
                        fields,
                        instantiation.component().parameters(),
                        parameters,
                        components.environment(instantiation))
                .stream()
                .map(ConstantEvaluation::value)
                .toList();
    }

    // ---- time-synchronous -----------------------------------------------------------------

    private Streams timeSynchronous(ComponentSymbol symbol, StreamTestSymbol test) {
        Map<String, List<List<Value>>> inputs = new LinkedHashMap<>();
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        Map<String, Integer> delayOf = new LinkedHashMap<>();
        int length = 0;
        for (StreamSymbol stream : test.streams()) {
            String port = stream.node().port().text();
            List<List<Value>> slices =
                    StreamLayout.slices(stream.node().elements(), values(stream));
            if (stream.kind() == TestSuite.Kind.EXPECT) {
                int delay = delay(symbol, stream);
                delayOf.put(port, delay);
                expected.put(port, slices);
                length = Math.max(length, slices.size() - delay);
            } else {
                inputs.put(port, slices);
                length = Math.max(length, slices.size());
            }
        }
        int slices = length;
        expected.replaceAll(
                (port, written) ->
                        padded(written, slices + Objects.requireNonNull(delayOf.get(port))));
        return new Streams(letters(inputs, slices), expected);
    }

    private static List<List<Value>> padded(List<List<Value>> slices, int length) {
        List<List<Value>> all = new ArrayList<>(slices);
        while (all.size() < length) {
            all.add(List.of());
        }
        return Collections.unmodifiableList(all);
    }

    private static List<Letter> letters(Map<String, List<List<Value>>> streams, int length) {
        List<Letter> letters = new ArrayList<>();
        for (int slice = 0; slice < length; slice++) {
            Map<String, List<Value>> messages = new LinkedHashMap<>();
            for (Map.Entry<String, List<List<Value>>> stream : streams.entrySet()) {
                if (slice < stream.getValue().size() && !stream.getValue().get(slice).isEmpty()) {
                    messages.put(stream.getKey(), stream.getValue().get(slice));
                }
            }
            letters.add(messages.isEmpty() ? Letter.SILENCE : new Letter(messages));
        }
        return letters;
    }

    /** How much later a checked port shows what the last input slice caused. */
    private int delay(ComponentSymbol component, StreamSymbol stream) {
        List<String> path = stream.node().port().parts().stream().map(Name::text).toList();
        if (path.size() == 1) {
            PortSymbol port = Lowering.resolved(stream.port(), stream.node().port());
            return port.isInput() ? 0 : delays.effective(component, port);
        }
        return InstancePath.delayInto(component, path, delays);
    }

    // ---- event-driven ---------------------------------------------------------------------

    private Streams eventDriven(StreamTestSymbol test) {
        List<Letter> events = new ArrayList<>();
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        for (StreamSymbol stream : test.streams()) {
            String port = stream.node().port().text();
            List<Value> messages = StreamLayout.messages(stream.node().elements(), values(stream));
            if (stream.kind() == TestSuite.Kind.EXPECT) {
                expected.put(port, List.of(messages));
            } else {
                messages.forEach(m -> events.add(Letter.of(Map.of(port, m))));
            }
        }
        return new Streams(events, expected);
    }

    private List<Value> values(StreamSymbol stream) {
        PortSymbol port = Lowering.resolved(stream.port(), stream.node().port());
        Type type = TypeLowering.lower(port.type());
        return stream.messages().stream()
                .map(m -> ConstantEvaluation.value(expressions.lower(m, type)))
                .toList();
    }
}
