package arcomat.report.gate;

import arcomat.analysis.evolution.Change;
import arcomat.analysis.evolution.Change.Relation;
import arcomat.analysis.evolution.Gate;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.verdict.VerdictText;
import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * What became of components: a line for each that changed and for each campaign, then the stories
 * of those that do not keep their promises, other findings, and a summary.
 */
public final class GateText {
    private static final int WIDEST = "incomparable".length();

    private GateText() {}

    public static String render(
            Gate gate, GatedCampaigns campaigns, List<Diagnostic> findings, Style style) {
        StringBuilder out = new StringBuilder();
        for (Gate.Entry entry : gate.entries()) {
            if (entry.change().relation() != Relation.UNCHANGED) {
                out.append(line(entry, style));
            }
        }
        out.append(campaigns.lines(WIDEST + 2, style));
        for (Gate.Entry entry : gate.entries()) {
            if (entry.change().relation().isDoubtful()) {
                story(entry, findings, style, out);
            }
        }
        for (Diagnostic finding : findings) {
            if (gate.entries().stream().noneMatch(entry -> isAbout(finding, entry))) {
                section(FindingsText.render(finding, style), out);
            }
        }
        return out.append(out.isEmpty() ? "" : "\n")
                .append(summary(gate, campaigns, style))
                .toString();
    }

    /** {@code refines p.Lift}, with what it has more. */
    static String line(Gate.Entry entry, Style style) {
        String word = Printable.word(entry.change().relation());
        String reason =
                entry.cause().map(part -> "; by its part " + part).orElse("")
                        + entry.excuse().map(why -> "; it is meant: " + why).orElse("");
        return VerdictText.paint(word, entry.answer(), style)
                + " ".repeat(WIDEST - word.length() + 2)
                + Printable.escape(entry.name() + reason)
                + "\n"
                + (entry.change().relation() == Relation.REFINES ? more(entry.change()) : "");
    }

    /** What a component that promises more has more. */
    private static String more(Change change) {
        return change.witnesses().stream()
                .map(Change.Witness::verdict)
                .filter(verdict -> !verdict.explanation().isEmpty())
                .map(GateText::more)
                .collect(Collectors.joining());
    }

    private static String more(Verdict verdict) {
        return " ".repeat(WIDEST + 2)
                + (verdict.trace().isEmpty() ? "" : "no longer: ")
                + Printable.escape(verdict.explanation().get(0).text())
                + "\n";
    }

    /** The finding, if there is one, then what shows it; that of a part is told there. */
    private static void story(
            Gate.Entry entry, List<Diagnostic> findings, Style style, StringBuilder out) {
        StringBuilder story = new StringBuilder();
        findings.stream()
                .filter(finding -> isAbout(finding, entry))
                .forEach(
                        finding ->
                                story.append(FindingsText.render(finding.withoutRelated(), style)));
        if (entry.cause().isEmpty() && !entry.change().witnesses().isEmpty()) {
            Change.Witness first = entry.change().witnesses().get(0);
            section(VerdictText.render(first.left(), first.right(), first.verdict(), style), story);
        }
        section(story.toString(), out);
    }

    private static void section(String text, StringBuilder out) {
        if (!text.isEmpty()) {
            out.append(out.isEmpty() ? "" : "\n").append(text);
        }
    }

    /** Findings about entries stand at their names. */
    private static boolean isAbout(Diagnostic finding, Gate.Entry entry) {
        Optional<Span> place = entry.fresh().or(entry::old);
        return entry.answer() != Answer.HOLDS && place.equals(Optional.of(finding.span()));
    }

    /** How many became what. */
    public static String summary(Gate gate, GatedCampaigns campaigns, Style style) {
        List<String> counts = new ArrayList<>();
        for (Relation relation : Relation.values()) {
            long number =
                    gate.entries().stream()
                            .filter(each -> each.change().relation() == relation)
                            .count();
            if (number > 0) {
                counts.add(number + " " + Printable.word(relation));
            }
        }
        String text = counts.isEmpty() ? "no components" : String.join(", ", counts);
        long meant = gate.entries().stream().filter(each -> each.excuse().isPresent()).count();
        String reasons = meant == 0 ? "" : " (" + meant + " with a reason)";
        return VerdictText.paint(text, gate.answer(), style) + reasons + campaigns.summary() + "\n";
    }
}
