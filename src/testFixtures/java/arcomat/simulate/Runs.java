package arcomat.simulate;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.ComponentBuilder;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Runs in few words: letters as {@code "frontUS=clear gotCoffee=true"}, traces as lines. */
public final class Runs {
    private Runs() {}

    static Letter letter(Component component, String text) {
        Map<String, Value> messages = new LinkedHashMap<>();
        for (String item : text.trim().split(" ")) {
            if (item.contains("=")) {
                String[] sides = item.split("=");
                Port port = component.port(sides[0]).orElseThrow();
                messages.put(port.name(), ComponentBuilder.value(port.type(), sides[1]));
            }
        }
        return Letter.of(messages);
    }

    public static List<Letter> letters(Component component, String... texts) {
        return Arrays.stream(texts).map(text -> letter(component, text)).toList();
    }

    public static Trace run(Component component, Choice choice, String... letters) {
        Interpreter interpreter = new Interpreter(component, List.of(), choice);
        return Simulation.run(interpreter, letters(component, letters));
    }

    /** One line per step: outputs, then what each automaton did. */
    public static List<String> lines(Trace trace) {
        List<String> lines = new ArrayList<>();
        for (Trace.Step step : trace.steps()) {
            StringBuilder line = new StringBuilder(outputs(step));
            for (Trace.Activity activity : step.activities()) {
                line.append(" | ");
                line.append(activity.instance().isEmpty() ? "" : activity.instance() + ": ");
                line.append(activity.before()).append(' ');
                line.append(
                        activity.cause() instanceof Trace.Taken taken
                                ? "t" + taken.index()
                                : ((Trace.Completed) activity.cause()).completion());
                line.append(' ').append(activity.after());
                line.append(activity.variables().isEmpty() ? "" : " " + activity.variables());
            }
            lines.add(line.toString());
        }
        trace.failure().ifPresent(failure -> lines.add("! " + failure));
        return lines;
    }

    public static String outputs(Trace.Step step) {
        List<String> items = new ArrayList<>();
        step.outputs()
                .messages()
                .forEach(
                        (port, values) ->
                                items.add(
                                        port
                                                + "="
                                                + String.join(
                                                        ",",
                                                        values.stream()
                                                                .map(Value::toString)
                                                                .toList())));
        return String.join(" ", items);
    }
}
