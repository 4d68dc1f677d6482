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
        if (trace.shown().size() > trace.steps().size()) {
            addEnd(table, trace, columns);
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

    private static void addStep(TextTable table, Trace.Step step, TraceColumns columns) {
        List<List<String>> done = new ArrayList<>();
        for (Trace.Activity activity : step.activities()) {
            done.add(
                    did(
                            columns,
                            TraceColumns.nameOf(activity),
                            state(activity),
                            CauseText.of(activity.cause())));
        }
        addLines(table, step.number(), step.inputs(), step.outputs(), columns, done);
    }

    /** What an earlier step has sent is seen in the one that goes wrong, too. */
    private static void addEnd(TextTable table, Trace trace, TraceColumns columns) {
        int number = trace.steps().size();
        Letter inputs = trace.received().get(number);
        Letter outputs = trace.shown().get(number);
        List<List<String>> done = List.of(did(columns, "", "", "error"));
        addLines(table, number, inputs, outputs, columns, done);
    }

    private static List<String> did(
            TraceColumns columns, String automaton, String state, String cause) {
        return columns.automata().size() > 1
                ? List.of(automaton, state, cause)
                : List.of(state, cause);
    }

    /** A step has as many lines as its longest list. */
    private static void addLines(
            TextTable table,
            int number,
            Letter received,
            Letter shown,
            TraceColumns columns,
            List<List<String>> done) {
        List<String> inputs = messages(received, columns.inputs());
        List<String> outputs = messages(shown, columns.outputs());
        int lines = Math.max(1, Math.max(inputs.size(), Math.max(outputs.size(), done.size())));
        for (int i = 0; i < lines; i++) {
            List<String> cells = new ArrayList<>();
            cells.add(i == 0 ? String.valueOf(number) : "");
            cells.add(i < inputs.size() ? inputs.get(i) : "");
            cells.add(i < outputs.size() ? outputs.get(i) : "");
            if (i < done.size()) {
                cells.addAll(done.get(i));
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
