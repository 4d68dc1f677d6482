package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Explored;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Moment;
import arcomat.model.Letter;
import arcomat.report.finding.FindingsText;
import arcomat.report.run.TraceTable;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * A verdict as a story: what went in and what came out, step by step, with the states on both
 * sides; then why that fails, with the places in the models.
 */
public final class VerdictText {
    private static final int MOST_SENTENCES = 8;
    private static final int MOST_STATES = 4;

    private VerdictText() {}

    /** Of a refinement. */
    @SuppressWarnings("NullAway") // a text shows no place
    public static String render(String left, String right, Verdict verdict, Style style) {
        return render(new Answered(left, right, null, verdict), style);
    }

    public static String render(Answered answered, Style style) {
        Verdict verdict = answered.verdict();
        StringBuilder out = new StringBuilder();
        out.append(answer(verdict.answer(), style))
                .append(": ")
                .append(Printable.escape(Terms.headline(answered)))
                .append('\n');
        if (!verdict.trace().isEmpty()) {
            out.append('\n').append(story(answered, style)).append('\n');
        }
        verdict.explanation().stream()
                .limit(MOST_SENTENCES)
                .forEach(sentence -> out.append(sentence(sentence, style)));
        int more = verdict.explanation().size() - MOST_SENTENCES;
        if (more > 0) {
            out.append("and ").append(more).append(" more\n");
        }
        verdict.notes().forEach(n -> out.append("  ").append(Printable.escape(n)).append('\n'));
        if (!verdict.explored().isNothing()) {
            out.append(style.quiet(explored(verdict))).append('\n');
        }
        return out.toString();
    }

    /** The answer as a word in its colour. */
    static String answer(Answer answer, Style style) {
        return paint(Printable.word(answer), answer, style);
    }

    /** A word in the colour of an answer. */
    public static String paint(String word, Answer answer, Style style) {
        return switch (answer) {
            case HOLDS -> style.good(word);
            case FAILS -> style.error(word);
            case UNKNOWN -> style.warning(word);
        };
    }

    private static String story(Answered answered, Style style) {
        Terms terms = Terms.of(answered);
        List<Moment> trace = answered.verdict().trace();
        TextTable table =
                new TextTable(
                        List.of(terms.step(), "input", "output", terms.left(), terms.right()));
        for (int i = 0; i < trace.size(); i++) {
            Moment moment = trace.get(i);
            table.addColumns(
                    List.of(
                            List.of(String.valueOf(i)),
                            inputs(moment.input()),
                            shown(moment),
                            List.of(moment.left()),
                            states(moment.right(), i == trace.size() - 1 ? terms.end() : "")));
        }
        return sides(answered) + table.render(style);
    }

    private static String sides(Answered answered) {
        String format =
                answered.question() == Answered.Question.INVARIANT
                        ? "component: %s\ninvariant: %s\n\n"
                        : "left:  %s\nright: %s\n\n";
        return format.formatted(
                Printable.escape(answered.left()), Printable.escape(answered.right()));
    }

    /** Port by port. */
    public static List<String> inputs(Letter letter) {
        List<String> inputs = new ArrayList<>();
        letter.messages()
                .forEach((port, values) -> inputs.add(port + " = " + TraceTable.text(values)));
        return inputs;
    }

    /** In the slice of an error what was sent before is still seen. */
    public static List<String> shown(Moment moment) {
        List<String> shown = outputs(moment.outputs());
        if (moment.error()) {
            shown.add("error");
        }
        return shown;
    }

    /** Port by port, those that are silent left out; a star where it is left open. */
    static List<String> outputs(Map<String, Sent> sent) {
        List<String> outputs = new ArrayList<>();
        sent.forEach(
                (port, messages) -> {
                    if (!messages.equals(Sent.SILENCE)) {
                        outputs.add(
                                port
                                        + " = "
                                        + (messages instanceof Sent.Messages ? messages : "*"));
                    }
                });
        return outputs;
    }

    private static List<String> states(List<String> states, String otherwise) {
        if (states.isEmpty()) {
            return List.of(otherwise);
        }
        if (states.size() <= MOST_STATES) {
            return states;
        }
        List<String> shown = new ArrayList<>(states.subList(0, MOST_STATES));
        shown.add("or " + (states.size() - MOST_STATES) + " more");
        return shown;
    }

    static String sentence(Sentence sentence, Style style) {
        String place = sentence.place().map(span -> FindingsText.placed(span, style)).orElse("");
        return Printable.escape(sentence.text()) + "\n" + place;
    }

    static String explored(Verdict verdict) {
        Explored explored = verdict.explored();
        String configurations =
                explored.left()
                        .map(
                                left ->
                                        " of %s and %s configurations"
                                                .formatted(
                                                        FindingsText.digits(left),
                                                        FindingsText.digits(explored.right())))
                        .orElse("; their configurations were not counted");
        return "explored "
                + FindingsText.count(explored.pairs(), "pair")
                + configurations
                + simulation(verdict);
    }

    private static String simulation(Verdict verdict) {
        String none = verdict.answer() == Answer.HOLDS ? "; there is no simulation" : "";
        return verdict.simulation().map(is -> is ? "; there is a simulation" : none).orElse("");
    }
}
