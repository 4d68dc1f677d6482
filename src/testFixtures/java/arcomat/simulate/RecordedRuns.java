package arcomat.simulate;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.ComponentBuilder;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Runs of time-synchronous components, as stream tests. */
public final class RecordedRuns {
    private RecordedRuns() {}

    /** A run over random letters. */
    public static Trace run(Component component, Choice choice, int seed, int slices) {
        Interpreter interpreter = new Interpreter(component, List.of(), choice);
        return Simulation.run(
                interpreter,
                Simulation.drawn(interpreter.network(), seed, 70).limit(slices).toList());
    }

    /**
     * What a trace shows, as a test of a component. The last input of the trace has shown no
     * reaction yet on late ports.
     *
     * @param component the one that ran, or another one with some of its ports
     */
    public static StreamTest test(Trace trace, Component component) {
        Network ran = Network.of(trace.component(), List.of());
        int read = Math.max(0, trace.steps().size() - 1);
        List<Letter> inputs =
                trace.steps().subList(0, read).stream().map(Trace.Step::inputs).toList();
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        for (Network.External output : ran.outputs()) {
            boolean late = ran.delayed().contains(output.signal());
            List<List<Value>> stream = new ArrayList<>();
            for (Trace.Step step : trace.steps().subList(0, late ? trace.steps().size() : read)) {
                stream.add(step.outputs().messages(output.name()));
            }
            expected.put(output.name(), stream);
        }
        return test(component, inputs, expected);
    }

    /** A test of a component; streams on ports that it lacks are left out. */
    public static StreamTest test(
            Component component, List<Letter> inputs, Map<String, List<List<Value>>> expected) {
        Map<String, List<List<Value>>> own = new LinkedHashMap<>(expected);
        own.keySet().removeIf(port -> component.port(port).isEmpty());
        List<Letter> read = new ArrayList<>();
        for (Letter letter : inputs) {
            Map<String, List<Value>> messages = new LinkedHashMap<>(letter.messages());
            messages.keySet().removeIf(port -> component.port(port).isEmpty());
            read.add(new Letter(messages));
        }
        return new StreamTest(
                "Suite", "test", component, List.of(), read, own, ComponentBuilder.NOWHERE);
    }
}
