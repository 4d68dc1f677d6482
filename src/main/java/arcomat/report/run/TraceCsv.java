package arcomat.report.run;

import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.report.text.CsvLine;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * A trace with one line per slice, for spreadsheets: a column per port, and for every automaton its
 * state after the slice and what made its step. Fields are quoted as RFC 4180 says; an empty field
 * is silence, several messages in one step are separated by blanks. A step that goes wrong shows
 * what was sent before it, and no states.
 */
public final class TraceCsv {
    private TraceCsv() {}

    public static String render(Trace trace) {
        TraceColumns columns = TraceColumns.of(trace);
        StringBuilder out = new StringBuilder(CsvLine.of(headings(columns)));
        for (Trace.Step step : trace.steps()) {
            List<String> fields = new ArrayList<>();
            fields.add(String.valueOf(step.number()));
            columns.inputs().forEach(port -> fields.add(messages(step.inputs(), port)));
            columns.outputs().forEach(port -> fields.add(messages(step.outputs(), port)));
            Map<String, Trace.Activity> activities = TraceColumns.activities(step);
            for (String automaton : columns.automata()) {
                Trace.Activity activity = activities.get(automaton);
                fields.add(activity == null ? "" : activity.after());
                fields.add(activity == null ? "" : CauseText.brief(activity.cause()));
            }
            out.append(CsvLine.of(fields));
        }
        if (trace.shown().size() > trace.steps().size()) {
            out.append(CsvLine.of(end(trace, columns)));
        }
        return out.toString();
    }

    private static List<String> end(Trace trace, TraceColumns columns) {
        int number = trace.steps().size();
        Letter received = trace.received().get(number);
        Letter shown = trace.shown().get(number);
        List<String> fields = new ArrayList<>();
        fields.add(String.valueOf(number));
        columns.inputs().forEach(port -> fields.add(messages(received, port)));
        columns.outputs().forEach(port -> fields.add(messages(shown, port)));
        columns.automata().forEach(automaton -> fields.addAll(List.of("", "")));
        return fields;
    }

    private static List<String> headings(TraceColumns columns) {
        List<String> headings = new ArrayList<>();
        headings.add(columns.unit());
        columns.inputs().forEach(port -> headings.add("in " + port));
        columns.outputs().forEach(port -> headings.add("out " + port));
        for (String automaton : columns.automata()) {
            headings.add(("state " + automaton).strip());
            headings.add(("because " + automaton).strip());
        }
        return headings;
    }

    private static String messages(Letter letter, String port) {
        return letter.messages(port).stream().map(Value::toString).collect(Collectors.joining(" "));
    }
}
