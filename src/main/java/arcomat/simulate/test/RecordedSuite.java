package arcomat.simulate.test;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.network.Network;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Writes a run down as a suite with one stream test, which repeats it. Where outputs have delay 1,
 * the last slice of the run shows the reaction to the one before: its own input has no reaction yet
 * and is left out. So is that of a slice that goes wrong, for the run shows in it what was sent
 * before.
 */
public final class RecordedSuite {
    private RecordedSuite() {}

    /**
     * The text of a suite in the package of the component.
     *
     * @param suite its name, which is the name of its file
     * @param arguments of the component
     * @param remarks lines that tell how the run came about, such as seed and choices
     */
    public static String of(
            String suite, Trace trace, List<Value> arguments, List<String> remarks) {
        Network network = Network.of(trace.component(), arguments);
        SuiteText.Entry entry =
                trace.component().profile() == Component.Profile.TIME_SYNCHRONOUS
                        ? slices(trace, network)
                        : events(trace, network);
        return SuiteText.of(suite, trace.component(), arguments, remarks, List.of(entry));
    }

    private static SuiteText.Entry slices(Trace trace, Network network) {
        int shown = shown(trace);
        Set<Integer> late = network.delayed();
        boolean delayed = network.outputs().stream().anyMatch(e -> late.contains(e.signal()));
        int read = delayed ? Math.max(0, shown - 1) : trace.steps().size();
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        for (Network.External output : network.outputs()) {
            int visible = late.contains(output.signal()) ? shown : read;
            expected.put(output.name(), stream(trace, output.name()).subList(0, visible));
        }
        return entry(inputs(trace).subList(0, read), expected);
    }

    /** A run that goes wrong before it has shown anything shows nothing that could be repeated. */
    private static int shown(Trace trace) {
        boolean nothing =
                trace.steps().isEmpty()
                        && trace.shown().stream().allMatch(each -> each.messages().isEmpty());
        return nothing ? 0 : trace.shown().size();
    }

    private static SuiteText.Entry events(Trace trace, Network network) {
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        for (Network.External output : network.outputs()) {
            expected.put(output.name(), stream(trace, output.name()));
        }
        return entry(inputs(trace), expected);
    }

    private static SuiteText.Entry entry(
            List<Letter> inputs, Map<String, List<List<Value>>> expected) {
        return new SuiteText.Entry(List.of(), "recorded", inputs, expected);
    }

    private static List<Letter> inputs(Trace trace) {
        return trace.steps().stream().map(Trace.Step::inputs).toList();
    }

    private static List<List<Value>> stream(Trace trace, String port) {
        return trace.shown().stream().map(letter -> letter.messages(port)).toList();
    }
}
