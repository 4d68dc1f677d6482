package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.report.text.OneLine;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/**
 * A trace with one line per slice, for spreadsheets: a column per port, and for every automaton its
 * state after the slice and what made its step. Fields are quoted as RFC 4180 says; an empty field
 * is silence, several messages in one step are separated by blanks. A step that goes wrong shows
 * what was sent before it, and no states.
 */
public final class TraceCsv implements RunText {
    private final Consumer<String> out;

    @SuppressWarnings("NullAway.Init") // a run begins with its columns
    private TraceColumns columns;

    /**
     * @param out takes the text, line by line
     */
    public TraceCsv(Consumer<String> out) {
        this.out = out;
    }

    @Override
    public void begin(Component component, TraceColumns all) {
        columns = all;
        out.accept(OneLine.csv(headings(columns)));
    }

    @Override
    public void step(Trace.Step step) {
        List<String> fields = fields(step.number(), step.inputs(), step.outputs());
        Map<String, Trace.Activity> activities = TraceColumns.activities(step);
        for (String automaton : columns.automata()) {
            Trace.Activity activity = activities.get(automaton);
            fields.add(activity == null ? "" : activity.after());
            fields.add(activity == null ? "" : CauseText.brief(activity.cause()));
        }
        out.accept(OneLine.csv(fields));
    }

    @Override
    public void end(int steps, Trace rest) {
        if (RunText.endsInError(rest)) {
            List<String> fields =
                    fields(steps, RunText.lastInputs(rest), RunText.lastOutputs(rest));
            columns.automata().forEach(automaton -> fields.addAll(List.of("", "")));
            out.accept(OneLine.csv(fields));
        }
    }

    private List<String> fields(int number, Letter received, Letter shown) {
        List<String> fields = new ArrayList<>();
        fields.add(String.valueOf(number));
        columns.inputs().forEach(port -> fields.add(messages(received, port)));
        columns.outputs().forEach(port -> fields.add(messages(shown, port)));
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
