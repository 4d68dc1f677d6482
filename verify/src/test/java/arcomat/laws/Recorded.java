package arcomat.laws;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.simulate.test.SuiteText;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** What a run has shown, as a stream test of a component that has at most its ports. */
final class Recorded {
    private static final String SUITE = "Run";

    private Recorded() {}

    static StreamTest test(Component component, Trace trace) {
        return test(component, component.outputs(), trace);
    }

    /**
     * @param outputs what it expects something of
     */
    static StreamTest test(Component component, List<Port> outputs, Trace trace) {
        List<Letter> inputs = new ArrayList<>();
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        outputs.forEach(port -> expected.put(port.name(), new ArrayList<>()));
        for (Trace.Step step : trace.steps()) {
            inputs.add(own(component, step.inputs()));
            for (Port port : outputs) {
                List<Value> shown = step.outputs().messages(port.name());
                List<List<Value>> stream = expected.get(port.name());
                if (component.profile() == Component.Profile.TIME_SYNCHRONOUS) {
                    stream.add(shown);
                } else if (stream.isEmpty()) {
                    stream.add(shown);
                } else {
                    List<Value> longer = new ArrayList<>(stream.get(0));
                    longer.addAll(shown);
                    stream.set(0, longer);
                }
            }
        }
        return new StreamTest(
                SUITE, "recorded", component, List.of(), inputs, expected, component.span());
    }

    /** What a component reads of a letter. */
    static Letter own(Component component, Letter letter) {
        Map<String, List<Value>> messages = new LinkedHashMap<>(letter.messages());
        messages.keySet().removeIf(name -> component.port(name).isEmpty());
        return new Letter(messages);
    }

    static String path(Component component) {
        return component.packageName() + "/" + SUITE + ".mt";
    }

    static String text(StreamTest test) {
        return SuiteText.of(
                SUITE,
                test.component(),
                List.of(),
                List.of(),
                List.of(new SuiteText.Entry(List.of(), test)));
    }
}
