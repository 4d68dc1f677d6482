package arcomat.report.gate;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.campaign.CampaignResult;
import arcomat.campaign.Judgement;
import arcomat.campaign.statistics.Decision;
import arcomat.report.campaign.CampaignReport;
import arcomat.report.campaign.CampaignVerdict;
import arcomat.report.finding.JunitXml.Case;
import arcomat.report.finding.JunitXml.Case.Outcome;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.verdict.VerdictText;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What campaigns say that a gate names, in the order in which it names them. */
public record GatedCampaigns(List<CampaignReport> reports) {
    private static final String GROUP = "campaign";

    public GatedCampaigns {
        reports = List.copyOf(reports);
    }

    /** Fails if one does, is unknown if one is, else holds. */
    public Answer answer() {
        return reports.stream().map(GatedCampaigns::answer).reduce(Answer.HOLDS, Answer::and);
    }

    private static Answer answer(CampaignReport report) {
        CampaignResult result = report.result();
        if (result.fails()) {
            return Answer.FAILS;
        }
        return result.isOpen() ? Answer.UNKNOWN : Answer.HOLDS;
    }

    /** A line for each, with as many letters for its word. */
    String lines(int width, Style style) {
        StringBuilder lines = new StringBuilder();
        for (CampaignReport each : reports) {
            String word = Printable.word(answer(each));
            lines.append(VerdictText.paint(word, answer(each), style))
                    .append(" ".repeat(width - word.length()))
                    .append(Printable.escape(each.file() + ": " + each.headline()))
                    .append('\n');
        }
        return lines.toString();
    }

    /** How many there are of each; empty where there are none. */
    String summary() {
        List<String> counts = new ArrayList<>();
        for (Answer each : Answer.values()) {
            long number = reports.stream().filter(report -> answer(report) == each).count();
            if (number > 0) {
                counts.add(number + " " + Printable.word(each));
            }
        }
        return counts.isEmpty() ? "" : "; campaigns: " + String.join(", ", counts);
    }

    /** For programs; empty where there are none. */
    Optional<List<CampaignVerdict>> verdicts() {
        return Optional.of(reports.stream().map(CampaignVerdict::of).toList())
                .filter(all -> !all.isEmpty());
    }

    /** What is required, a case each. */
    List<Case> cases() {
        List<Case> all = new ArrayList<>();
        for (CampaignReport report : reports) {
            report.result().judgements().forEach(each -> all.add(of(each, report.file())));
        }
        return all;
    }

    private static Case of(Judgement judgement, String file) {
        Outcome outcome =
                judgement.decision() == Decision.FAILS
                        ? Outcome.FAILED
                        : judgement.isOpen() ? Outcome.UNDECIDED : Outcome.PASSED;
        return new Case(
                GROUP,
                file + ": " + judgement.subject(),
                Optional.of(judgement.place()),
                outcome,
                outcome == Outcome.PASSED ? "" : judgement.word(),
                judgement.because());
    }
}
