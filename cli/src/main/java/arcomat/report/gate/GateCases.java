package arcomat.report.gate;

import arcomat.analysis.evolution.Change;
import arcomat.analysis.evolution.Gate;
import arcomat.report.finding.JunitXml.Case;
import arcomat.report.finding.JunitXml.Case.Outcome;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.verdict.VerdictText;

import java.util.List;
import java.util.stream.Stream;

/** What became of components as cases, one each. */
public final class GateCases {
    private static final String GROUP = "gate";

    private GateCases() {}

    /** Then what campaigns require. */
    public static List<Case> of(Gate gate, GatedCampaigns campaigns) {
        return Stream.concat(gate.entries().stream().map(GateCases::of), campaigns.cases().stream())
                .toList();
    }

    private static Case of(Gate.Entry entry) {
        Outcome outcome =
                switch (entry.answer()) {
                    case HOLDS -> Outcome.PASSED;
                    case FAILS -> Outcome.FAILED;
                    case UNKNOWN -> Outcome.UNDECIDED;
                };
        return new Case(
                GROUP,
                entry.name(),
                entry.fresh().or(entry::old),
                outcome,
                outcome == Outcome.PASSED ? "" : message(entry),
                details(entry));
    }

    private static String message(Gate.Entry entry) {
        String reason = entry.change().reason();
        return Printable.word(entry.change().relation()) + (reason.isEmpty() ? "" : ": " + reason);
    }

    private static String details(Gate.Entry entry) {
        StringBuilder details = new StringBuilder(GateText.line(entry, Style.PLAIN));
        for (Change.Witness each : entry.change().witnesses()) {
            details.append('\n')
                    .append(
                            VerdictText.render(
                                    each.left(), each.right(), each.verdict(), Style.PLAIN));
        }
        return details.toString();
    }
}
