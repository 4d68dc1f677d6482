package arcomat.report.verdict;

import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.contradiction.Consistency.Contradiction;
import arcomat.analysis.game.CounterStrategy.Turn;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.model.Automaton;
import arcomat.model.Letter;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Contradictions as stories: what goes in, what may be answered, and why nothing complies in the
 * end. Where there are none, the controller that shows it.
 */
public final class ConsistencyText {
    private static final int MOST_SENTENCES = 12;
    private static final int MOST_STEPS = 40;
    private static final int LONGEST_CONTROLLER = 100;

    private ConsistencyText() {}

    /**
     * @param title whose requirements they are
     * @param controller its text
     * @param file where that was written
     */
    public static String render(
            String title,
            Consistency found,
            Optional<String> controller,
            Optional<String> file,
            Style style) {
        StringBuilder out = new StringBuilder();
        out.append(VerdictText.answer(found.answer(), style))
                .append(": ")
                .append(Printable.escape(headline(title, found)))
                .append('\n');
        for (Contradiction contradiction : found.contradictions()) {
            out.append('\n').append(story(contradiction, style));
        }
        found.notes().forEach(n -> out.append("  ").append(Printable.escape(n)).append('\n'));
        controller.ifPresent(text -> out.append(controller(text, file)));
        String explored = "explored " + FindingsText.count(found.explored(), "position");
        return out.append(style.quiet(explored)).append('\n').toString();
    }

    static String headline(String title, Consistency found) {
        return switch (found.answer()) {
            case HOLDS -> "the requirements of " + title + " do not contradict each other";
            case FAILS -> "requirements of " + title + " contradict each other";
            case UNKNOWN -> found.reason();
        };
    }

    private static String controller(String text, Optional<String> file) {
        if (file.isPresent()) {
            return "wrote a controller that keeps them to " + Printable.escape(file.get()) + "\n";
        }
        List<String> lines = List.of(text.split("\n"));
        return lines.size() > LONGEST_CONTROLLER
                ? "a controller that keeps them is long; --out DIR writes it to a file\n"
                : "\n"
                        + lines.stream()
                                .map(l -> "    " + l)
                                .map(String::stripTrailing)
                                .collect(Collectors.joining("\n", "", "\n\n"));
    }

    /** The requirements by name; one without a name by its line. */
    static List<String> names(Contradiction contradiction) {
        return contradiction.requirements().stream().map(ConsistencyText::name).toList();
    }

    static String name(Automaton automaton) {
        return automaton.name().isEmpty()
                ? "the automaton in line " + automaton.span().startPosition().line()
                : automaton.name();
    }

    private static String story(Contradiction contradiction, Style style) {
        StringBuilder out = new StringBuilder();
        String names = Printable.escape(String.join(", ", names(contradiction)));
        out.append(style.strong(names))
                .append(": no system keeps ")
                .append(contradiction.requirements().size() == 2 ? "both" : "all of them");
        out.append(contradiction.minimal() ? "" : "; perhaps some of them need not be among these")
                .append('\n')
                .append(Printable.escape(summary(contradiction)))
                .append("\n\n")
                .append(table(contradiction).render(style))
                .append('\n');
        return out.append(demands(contradiction, style)).toString();
    }

    /** What the requirements ask for where nothing complies. */
    private static String demands(Contradiction contradiction, Style style) {
        StringBuilder out = new StringBuilder();
        List<Contradiction.Step> steps = contradiction.steps();
        boolean several = steps.stream().filter(step -> step.answers().isEmpty()).count() > 1;
        int shown = 0;
        int all = 0;
        for (int i = 0; i < steps.size(); i++) {
            List<Sentence> sentences = steps.get(i).demands();
            all += sentences.size();
            if (!sentences.isEmpty() && shown + sentences.size() <= MOST_SENTENCES) {
                out.append(several ? "In step " + i + " nothing complies.\n" : "");
                sentences.forEach(each -> out.append(VerdictText.sentence(each, style)));
                shown += sentences.size();
            }
        }
        return out.append(all > shown ? "and " + (all - shown) + " more\n" : "").toString();
    }

    static String summary(Contradiction contradiction) {
        if (contradiction.word().isEmpty()) {
            return contradiction.decided()
                    ? "which inputs show that depends on what is answered:"
                    : "what to send depends on what is answered, or takes a search that was given"
                            + " up:";
        }
        List<Letter> word = contradiction.word().get();
        if (word.isEmpty()) {
            return "they do not agree on how to begin:";
        }
        return "after "
                + (word.size() == 1 ? "this input" : "these " + word.size() + " inputs")
                + " no output complies, whatever was sent before:";
    }

    private static TextTable table(Contradiction contradiction) {
        TextTable table = new TextTable(List.of("step", "input", "output", "then"));
        List<Contradiction.Step> steps = contradiction.steps();
        for (int i = 0; i < Math.min(steps.size(), MOST_STEPS); i++) {
            add(table, i, steps.get(i));
        }
        if (steps.size() > MOST_STEPS) {
            table.add(List.of("", "and " + (steps.size() - MOST_STEPS) + " more", "", ""));
        }
        return table;
    }

    private static void add(TextTable table, int number, Contradiction.Step step) {
        List<String> outputs = new ArrayList<>();
        List<String> next = new ArrayList<>();
        for (Turn.Answer answer : step.answers()) {
            List<String> sent = VerdictText.outputs(answer.outputs());
            outputs.add(sent.isEmpty() ? "nothing" : String.join(", ", sent));
            next.add(String.valueOf(answer.next()));
        }
        if (outputs.isEmpty()) {
            outputs.add("none complies");
        }
        table.addColumns(
                List.of(
                        List.of(String.valueOf(number)),
                        VerdictText.inputs(step.input()),
                        outputs,
                        next));
    }
}
