package arcomat.report.verdict;

import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.Examination.Unexamined;
import arcomat.analysis.automaton.Finding;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Moment;
import arcomat.model.Letter;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;
import arcomat.source.Diagnostic;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** Findings about automata, each with the shortest run to where it is seen. */
public final class ExaminationText {
    private ExaminationText() {}

    /** The findings, then a line on the automaton. */
    public static String render(Examination examination, Style style) {
        StringBuilder out = new StringBuilder();
        for (Finding finding : examination.findings()) {
            out.append(FindingsText.render(finding.diagnostic(), style));
            if (!finding.trace().isEmpty()) {
                out.append(story(finding, style));
            }
            out.append('\n');
        }
        return out.append(VerdictText.answer(examination.answer(), style))
                .append(": ")
                .append(Printable.escape(title(examination)))
                .append(", ")
                .append(summary(examination, style))
                .append('\n')
                .toString();
    }

    /** A line on a component that was not looked at. */
    public static String render(Unexamined unexamined, Style style) {
        return VerdictText.answer(Answer.UNKNOWN, style)
                + ": "
                + Printable.escape(unexamined.component() + " " + unexamined.reason());
    }

    /** A line on findings that are declared to be meant. */
    public static String meant(int findings, Style style) {
        return style.quiet(
                FindingsText.count(findings, "finding")
                        + (findings == 1 ? " is" : " are")
                        + " suppressed in the models");
    }

    /** The component with its arguments, and the automaton where there are several. */
    static String title(Examination examination) {
        return examination.promise().title();
    }

    private static String summary(Examination examination, Style style) {
        List<Diagnostic> found = examination.findings().stream().map(Finding::diagnostic).toList();
        String explored = FindingsText.count(examination.explored(), "configuration");
        String counted = FindingsText.summary(found, 0, style);
        StringBuilder out = new StringBuilder(counted + " in " + explored);
        if (!examination.obstacle().isEmpty()) {
            out.append("; ").append(Printable.escape(examination.obstacle()));
        }
        return out.toString();
    }

    private static String story(Finding finding, Style style) {
        TextTable table = new TextTable(List.of("step", "input", "output", "state"));
        int number = 0;
        for (Moment moment : finding.trace()) {
            String outputs = String.join(", ", VerdictText.outputs(moment.outputs()));
            table.add(row(number++, moment.input(), outputs, moment.left()));
        }
        int last = number;
        finding.witness().ifPresent(letter -> table.add(row(last, letter, "", "?")));
        return Arrays.stream(table.render(style).split("\n"))
                .map(line -> "  " + line + "\n")
                .collect(Collectors.joining());
    }

    private static List<String> row(int number, Letter input, String outputs, String state) {
        String inputs =
                input.isSilent() && number > 0
                        ? "--"
                        : String.join(", ", VerdictText.inputs(input));
        return List.of(
                String.valueOf(number),
                Printable.escape(inputs),
                Printable.escape(outputs),
                Printable.escape(state));
    }
}
