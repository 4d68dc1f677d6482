package arcomat.report.verdict;

import arcomat.analysis.coverage.Goal;
import arcomat.analysis.coverage.TransitionTests;
import arcomat.analysis.coverage.TransitionTests.Uncovered;
import arcomat.analysis.coverage.TransitionTests.Untold;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;
import arcomat.report.text.Snippet;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;
import arcomat.source.Severity;
import arcomat.source.Span;

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
                    .append('\n');
        }
        found.uncovered().forEach(each -> out.append(uncovered(each, style)));
        found.untold().forEach(each -> out.append(untold(each, style)));
        int taken = found.transitions() - found.uncovered().size();
        String summary = taken + " of " + FindingsText.count(found.transitions(), "transition");
        out.append(found.uncovered().isEmpty() ? style.good(summary) : style.warning(summary))
                .append(" of ")
                .append(Printable.escape(title))
                .append(taken == 1 ? " is taken\n" : " are taken\n");
        return out.toString();
    }

    private static TextTable table(TransitionTests.Result found) {
        TextTable table = new TextTable(java.util.List.of("test", "letters", "transitions"));
        for (TransitionTests.Test test : found.tests()) {
            table.add(
                    java.util.List.of(
                            Printable.escape(test.streams().name()),
                            String.valueOf(test.streams().inputs().size()),
                            String.valueOf(test.covers().size())));
        }
        return table;
    }

    private static String untold(Untold untold, Style style) {
        Goal transition = untold.mistake().transition();
        Span span = transition.transition().span();
        return style.strong(FindingsText.place(span))
                + ": no test tells if "
                + transition.source()
                + " -> "
                + transition.target()
                + " "
                + Printable.escape(untold.mistake().what())
                + ": "
                + Printable.escape(untold.reason())
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
