package arcomat.report.run;

import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/**
 * A trace to be read from top to bottom: for every slice what came in, what was to be seen outside,
 * and what each automaton did for which reason.
 */
public final class TraceTable {
    private TraceTable() {}

    public static String render(Trace trace, Style style) {
        TraceColumns columns = TraceColumns.of(trace);
        TextTable table = new TextTable(headings(columns));
        for (Trace.Step step : trace.steps()) {
            addStep(table, step, columns);
        }
        StringBuilder out = new StringBuilder(table.render(style));
        trace.failure()
                .ifPresent(
                        failure ->
                                out.append(style.error("stopped"))
                                        .append(": ")
                                        .append(Printable.escape(failure))
                                        .append('\n'));
        return out.toString();
    }

    private static List<String> headings(TraceColumns columns) {
        boolean several = columns.automata().size() > 1;
        return several
                ? List.of(columns.unit(), "input", "output", "component", "state", "because")
                : List.of(columns.unit(), "input", "output", "state", "because");
    }

    /** A step has as many lines as its longest list. */
    private static void addStep(TextTable table, Trace.Step step, TraceColumns columns) {
        List<String> inputs = messages(step.inputs(), columns.inputs());
        List<String> outputs = messages(step.outputs(), columns.outputs());
        List<Trace.Activity> activities = step.activities();
        int lines =
                Math.max(1, Math.max(inputs.size(), Math.max(outputs.size(), activities.size())));
        for (int i = 0; i < lines; i++) {
            List<String> cells = new ArrayList<>();
            cells.add(i == 0 ? String.valueOf(step.number()) : "");
            cells.add(i < inputs.size() ? inputs.get(i) : "");
            cells.add(i < outputs.size() ? outputs.get(i) : "");
            if (i < activities.size()) {
                Trace.Activity activity = activities.get(i);
                if (columns.automata().size() > 1) {
                    cells.add(TraceColumns.nameOf(activity));
                }
                cells.add(state(activity));
                cells.add(CauseText.of(activity.cause()));
            }
            table.add(cells);
        }
    }

    /** {@code cmd = fwd}, one per port that carries something. */
    private static List<String> messages(Letter letter, List<String> ports) {
        List<String> cells = new ArrayList<>();
        for (String port : ports) {
            List<Value> values = letter.messages(port);
            if (!values.isEmpty()) {
                cells.add(Printable.escape(port + " = " + text(values)));
            }
        }
        return cells;
    }

    public static String text(List<Value> values) {
        return values.stream().map(Value::toString).collect(Collectors.joining(", "));
    }

    private static String state(Trace.Activity activity) {
        String text =
                activity.before().equals(activity.after())
                        ? activity.before()
                        : activity.before() + " -> " + activity.after();
        if (!activity.variables().isEmpty()) {
            text +=
                    activity.variables().entrySet().stream()
                            .map(v -> v.getKey() + " = " + v.getValue())
                            .collect(Collectors.joining(", ", " (", ")"));
        }
        return Printable.escape(text);
    }
}
