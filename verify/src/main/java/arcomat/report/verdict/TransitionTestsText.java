package arcomat.report.verdict;

import arcomat.analysis.coverage.Goal;
import arcomat.analysis.coverage.TransitionTests;
import arcomat.analysis.coverage.TransitionTests.Gap;
import arcomat.analysis.coverage.TransitionTests.Uncovered;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;
import arcomat.report.text.Snippet;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;
import arcomat.source.Severity;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Which tests there are, what they take, and what cannot be taken. */
public final class TransitionTestsText {
    private TransitionTestsText() {}

    /**
     * @param title what the tests are for
     * @param file where they were written; empty where there are none
     */
    public static String render(
            String title, String file, TransitionTests.Result found, Style style) {
        StringBuilder out = new StringBuilder();
        if (!found.tests().isEmpty()) {
            out.append("wrote ")
                    .append(FindingsText.count(found.tests().size(), "test"))
                    .append(" to ")
                    .append(Printable.escape(file))
                    .append("\n\n")
                    .append(table(found).render(style))
                    .append('\n')
                    .append(vacuous(found));
        }
        found.uncovered().forEach(each -> out.append(uncovered(each, style)));
        out.append(gaps(found.gaps(), style));
        int taken = found.transitions() - found.uncovered().size();
        String summary = taken + " of " + FindingsText.count(found.transitions(), "transition");
        out.append(found.uncovered().isEmpty() ? style.good(summary) : style.warning(summary))
                .append(" of ")
                .append(Printable.escape(title))
                .append(taken == 1 ? " is taken\n" : " are taken\n");
        return out.toString();
    }

    private static TextTable table(TransitionTests.Result found) {
        TextTable table = new TextTable(List.of("test", "letters", "transitions"));
        for (TransitionTests.Test test : found.tests()) {
            table.add(
                    List.of(
                            Printable.escape(test.streams().name()),
                            String.valueOf(test.streams().inputs().size()),
                            String.valueOf(test.covers().size())));
        }
        return table;
    }

    /** Who runs the tests is told of these again. */
    private static String vacuous(TransitionTests.Result found) {
        long count = found.tests().stream().filter(test -> !test.promised()).count();
        return count == 0
                ? ""
                : FindingsText.count(count, "test")
                        + (count == 1 ? " ends" : " end")
                        + " where the model promises nothing any more, and "
                        + (count == 1 ? "expects" : "expect")
                        + " there what code does\n\n";
    }

    /** What no test tells, by the reason, then by the transition. */
    private static String gaps(List<Gap> gaps, Style style) {
        StringBuilder out = new StringBuilder();
        Map<String, List<Gap>> reasons = new LinkedHashMap<>();
        for (Gap gap : gaps) {
            reasons.computeIfAbsent(heading(gap), any -> new ArrayList<>()).add(gap);
        }
        reasons.forEach(
                (heading, alike) -> {
                    out.append(Printable.escape(heading)).append(":\n");
                    alike.forEach(gap -> out.append(gap(gap, style)));
                    out.append('\n');
                });
        return out.toString();
    }

    private static String heading(Gap gap) {
        return (gap.certain() ? "no test tells, " : "not known whether a test could tell, ")
                + gap.reason();
    }

    private static String gap(Gap gap, Style style) {
        Goal transition = gap.transition();
        return "  "
                + style.strong(FindingsText.place(transition.transition().span()))
                + ": if "
                + transition.source()
                + " -> "
                + transition.target()
                + " "
                + Printable.escape(gap.words())
                + "\n";
    }

    private static String uncovered(Uncovered uncovered, Style style) {
        Span span = uncovered.transition().transition().span();
        return style.strong(FindingsText.place(span))
                + ": not taken: "
                + Printable.escape(uncovered.reason())
                + "\n"
                + Snippet.render(span, Severity.WARNING, style)
                + "\n";
    }
}
