package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/**
 * A trace to be read from top to bottom: for every slice what came in, what was to be seen outside,
 * and what each automaton did for which reason.
 */
public final class TraceTable implements RunText {
    /** So many slices tell how wide columns are; longer texts of later ones are broken. */
    private static final int SLICES_AHEAD = 1000;

    /** Of the column with the numbers, where there are more. */
    private static final int NUMBERS = 8;

    private final Consumer<String> out;
    private final Style style;
    private final boolean whyNot;

    @SuppressWarnings("NullAway.Init") // a run begins with its columns
    private TraceColumns columns;

    @SuppressWarnings("NullAway.Init") // a run begins with its columns
    private TextTable table;

    private boolean begun;

    /**
     * @param out takes the text, piece by piece
     * @param whyNot whether it says, below what no transition answered, which one came nearest
     */
    public TraceTable(Consumer<String> out, Style style, boolean whyNot) {
        this.out = out;
        this.style = style;
        this.whyNot = whyNot;
    }

    @Override
    public void begin(Component component, TraceColumns all) {
        columns = all;
        table = new TextTable(headings(columns));
    }

    @Override
    public void step(Trace.Step step) {
        List<String> automata = new ArrayList<>();
        List<String> states = new ArrayList<>();
        List<String> causes = new ArrayList<>();
        for (Trace.Activity each : step.activities()) {
            automata.add(TraceColumns.nameOf(each));
            states.add(state(each));
            causes.add(CauseText.of(each.cause()));
            if (whyNot && each.nearest().isPresent()) {
                automata.add("");
                states.add("");
                causes.add(each.nearest().get().words());
            }
        }
        addLines(step.number(), step.inputs(), step.outputs(), automata, states, causes);
        if (step.number() == SLICES_AHEAD) {
            out.accept(table.begin(style, NUMBERS));
            begun = true;
        }
    }

    /** What an earlier step has sent is seen in the one that goes wrong, too. */
    @Override
    public void end(int steps, Trace rest) {
        if (RunText.endsInError(rest)) {
            addLines(
                    steps,
                    RunText.lastInputs(rest),
                    RunText.lastOutputs(rest),
                    List.of(),
                    List.of(),
                    List.of("error"));
        }
        if (!begun) {
            out.accept(table.render(style));
        }
        rest.failure()
                .ifPresent(
                        failure ->
                                out.accept(
                                        style.error("stopped")
                                                + ": "
                                                + Printable.escape(failure)
                                                + "\n"));
    }

    private static List<String> headings(TraceColumns columns) {
        boolean several = columns.automata().size() > 1;
        return several
                ? List.of(columns.unit(), "input", "output", "component", "state", "because")
                : List.of(columns.unit(), "input", "output", "state", "because");
    }

    /** A step has as many lines as its longest list. */
    private void addLines(
            int number,
            Letter received,
            Letter shown,
            List<String> automata,
            List<String> states,
            List<String> causes) {
        List<List<String>> lists = new ArrayList<>();
        lists.add(List.of(String.valueOf(number)));
        lists.add(messages(received, columns.inputs()));
        lists.add(messages(shown, columns.outputs()));
        if (columns.automata().size() > 1) {
            lists.add(automata);
        }
        lists.add(states);
        lists.add(causes);
        TextTable.rows(lists).forEach(this::add);
    }

    private void add(List<String> cells) {
        if (begun) {
            out.accept(table.more(cells));
        } else {
            table.add(cells);
        }
    }

    /** {@code cmd = fwd}, one per port that carries something. */
    private static List<String> messages(Letter letter, List<String> ports) {
        List<String> cells = new ArrayList<>();
        for (String port : ports) {
            List<Value> values = letter.messages(port);
            if (!values.isEmpty()) {
                cells.add(port + " = " + text(values));
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
        return text;
    }
}
