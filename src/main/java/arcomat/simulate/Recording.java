package arcomat.simulate;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.Network;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * Writes a run down as a suite with one stream test, which repeats it. Where outputs have delay 1,
 * the last slice of the run shows the reaction to the one before: its own input has no reaction yet
 * and is left out.
 */
public final class Recording {
    private final Trace trace;
    private final Network network;
    private final StringBuilder text = new StringBuilder();

    private Recording(Trace trace, List<Value> arguments) {
        this.trace = trace;
        this.network = Network.of(trace.component(), arguments);
    }

    /**
     * The text of a suite in the package of the component.
     *
     * @param suite its name, which is the name of its file
     * @param arguments of the component
     * @param remarks lines that tell how the run came about, such as seed and choices
     */
    public static String of(
            String suite, Trace trace, List<Value> arguments, List<String> remarks) {
        return new Recording(trace, arguments).write(suite, arguments, remarks);
    }

    private String write(String suite, List<Value> arguments, List<String> remarks) {
        Component component = trace.component();
        if (!component.packageName().isEmpty()) {
            line("package " + component.packageName() + ";");
            line("");
        }
        remarks.forEach(remark -> line("// " + remark.replaceAll("\\R", " ")));
        line("testsuite " + suite + " for " + component.name() + list(arguments) + " {");
        line("  test recorded {");
        if (component.profile() == Component.Profile.TIME_SYNCHRONOUS) {
            slices();
        } else {
            events();
        }
        line("  }");
        line("}");
        return text.toString();
    }

    private void line(String line) {
        text.append(line).append('\n');
    }

    private static String list(List<Value> arguments) {
        return arguments.isEmpty()
                ? ""
                : arguments.stream()
                        .map(Value::toString)
                        .collect(Collectors.joining(", ", "(", ")"));
    }

    private void slices() {
        int shown = trace.steps().size();
        boolean delayed = network.outputs().stream().anyMatch(e -> isDelayed(e.port()));
        int read = delayed ? Math.max(0, shown - 1) : shown;
        line("    input {");
        for (Network.External input : network.inputs()) {
            stream(input.name(), read, true);
        }
        line("    }");
        line("    expect {");
        for (Network.External output : network.outputs()) {
            stream(output.name(), isDelayed(output.port()) ? shown : read, false);
        }
        line("    }");
    }

    private static boolean isDelayed(Port port) {
        return !port.isInput() && port.delay() > 0;
    }

    private void stream(String port, int count, boolean input) {
        List<String> slices = new ArrayList<>();
        for (Trace.Step step : trace.steps().subList(0, count)) {
            List<Value> messages = (input ? step.inputs() : step.outputs()).messages(port);
            slices.add(
                    messages.stream().map(value -> value + ", ").collect(Collectors.joining())
                            + "Tk");
        }
        line("      " + port + ": <" + runLengths(slices) + ">;");
    }

    /** {@code a, Tk} three times is {@code 3*(a, Tk)}. */
    private static String runLengths(List<String> elements) {
        List<String> runs = new ArrayList<>();
        for (int start = 0; start < elements.size(); ) {
            String element = elements.get(start);
            int end = start;
            while (end < elements.size() && elements.get(end).equals(element)) {
                end++;
            }
            String repeated = element.endsWith(", Tk") ? "(" + element + ")" : element;
            runs.add(end - start == 1 ? element : (end - start) + "*" + repeated);
            start = end;
        }
        return String.join(", ", runs);
    }

    private void events() {
        line("    events {");
        for (Trace.Step step : trace.steps()) {
            step.inputs()
                    .messages()
                    .forEach(
                            (port, values) ->
                                    values.forEach(v -> line("      " + port + ": " + v + ";")));
        }
        line("    }");
        line("    expect {");
        for (Network.External output : network.outputs()) {
            List<String> messages =
                    StreamTests.stream(trace, output.name()).stream().map(Value::toString).toList();
            line("      " + output.name() + ": <" + runLengths(messages) + ">;");
        }
        line("    }");
    }
}
