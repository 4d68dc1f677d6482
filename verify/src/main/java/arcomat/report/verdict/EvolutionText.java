package arcomat.report.verdict;

import arcomat.analysis.evolution.Evolution;
import arcomat.analysis.evolution.Evolution.Break;
import arcomat.analysis.evolution.Evolution.Culprit;
import arcomat.analysis.refinement.Verdict;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;
import arcomat.report.text.Snippet;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;
import arcomat.source.Severity;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;

/**
 * The matrix of verdicts along versions, then each break with its story and the edits behind it.
 */
public final class EvolutionText {
    private EvolutionText() {}

    public static String render(Evolution evolution, Style style) {
        StringBuilder out = new StringBuilder(matrix(evolution, style));
        for (Break each : evolution.breaks()) {
            out.append('\n').append(story(evolution, each, style));
        }
        return out.toString();
    }

    private static String matrix(Evolution evolution, Style style) {
        List<String> headings = new ArrayList<>(List.of("", "version"));
        for (int i = 1; i < evolution.titles().size(); i++) {
            headings.add("refines " + i);
        }
        TextTable table = new TextTable(headings);
        for (int version = 0; version < evolution.titles().size(); version++) {
            List<String> cells = new ArrayList<>();
            cells.add(String.valueOf(version + 1));
            cells.add(Printable.escape(evolution.titles().get(version)));
            for (Verdict verdict : evolution.verdicts().get(version)) {
                cells.add(Printable.word(verdict.answer()));
            }
            table.add(cells);
        }
        return table.render(style);
    }

    private static String story(Evolution evolution, Break each, Style style) {
        String version = evolution.titles().get(each.version());
        String promise = evolution.titles().get(each.promise());
        StringBuilder out =
                new StringBuilder(VerdictText.render(version, promise, each.verdict(), style));
        if (each.culprits().isEmpty()) {
            out.append("No single edit of version ")
                    .append(each.version() + 1)
                    .append(" explains it.\n");
        }
        for (Culprit culprit : each.culprits()) {
            out.append("Without this edit of version ")
                    .append(each.version() + 1)
                    .append(" it would hold:\n");
            culprit.old().ifPresent(span -> out.append(place("was", span, style)));
            culprit.fresh().ifPresent(span -> out.append(place("is", span, style)));
        }
        return out.toString();
    }

    private static String place(String when, Span span, Style style) {
        return "  %s %s\n".formatted(when, FindingsText.place(span))
                + Snippet.render(span, Severity.WARNING, style);
    }
}
