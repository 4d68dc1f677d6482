package arcomat.report.campaign;

import arcomat.campaign.CampaignResult;
import arcomat.campaign.CampaignResult.Occurrence;
import arcomat.campaign.CampaignResult.Spread;
import arcomat.campaign.Figure;
import arcomat.campaign.Judgement;
import arcomat.campaign.Row;
import arcomat.campaign.WorstSearch;
import arcomat.campaign.statistics.Confidence;
import arcomat.campaign.statistics.ConfidenceInterval;
import arcomat.campaign.statistics.Decision;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;

import java.util.List;

/** The result of a campaign for people: how often, how much, what that proves, what to look at. */
public final class CampaignText {
    private final CampaignResult result;
    private final RunAgain replay;
    private final Style style;

    public CampaignText(CampaignResult result, RunAgain replay, Style style) {
        this.result = result;
        this.replay = replay;
        this.style = style;
    }

    /** Everything but how many runs there were. */
    public String render() {
        StringBuilder text = new StringBuilder();
        if (result.made() > 0) {
            text.append(events()).append('\n').append(measures()).append('\n');
        }
        result.judgements().forEach(each -> text.append(line(each)).append('\n'));
        text.append(notable());
        return text.toString();
    }

    private String events() {
        TextTable table = new TextTable(List.of("event", "runs", "share", "surely (95 %)"));
        for (Occurrence each : result.occurrences()) {
            ConfidenceInterval interval = each.interval(Confidence.USUAL);
            table.add(
                    List.of(
                            each.column().name(),
                            "%,d of %,d".formatted(each.runs(), each.known()),
                            number(each.share()),
                            number(interval.low()) + " to " + number(interval.high())));
        }
        return table.render(style);
    }

    private String measures() {
        TextTable table =
                new TextTable(
                        List.of("measure", "least", "25 %", "median", "75 %", "greatest", "runs"));
        for (Spread each : result.spreads()) {
            if (each.known() > 0) {
                table.add(
                        List.of(
                                each.column().name(),
                                number(each.least()),
                                number(each.lower()),
                                number(each.median()),
                                number(each.upper()),
                                number(each.greatest()),
                                "%,d".formatted(each.known())));
            }
        }
        return table.render(style);
    }

    static String number(double value) {
        if (Double.isNaN(value)) {
            return "-";
        }
        if (Double.isInfinite(value)) {
            return value > 0 ? "never" : "-";
        }
        return Figure.text(value);
    }

    private String line(Judgement judgement) {
        String word = judgement.word() + ": ";
        String shown =
                switch (judgement.decision()) {
                    case HOLDS -> style.good(word);
                    case FAILS -> style.error(word);
                    case UNDECIDED -> judgement.isDemand() ? style.warning(word) : word;
                };
        return shown + Printable.escape(judgement.subject() + " (" + judgement.because() + ")");
    }

    /** The worst run, and how to see it. */
    private String notable() {
        if (result.notable().isEmpty()) {
            return "";
        }
        Row worst = result.notable().get(0);
        boolean wrong =
                result.judgements().stream().anyMatch(each -> each.decision() == Decision.FAILS);
        return "\n"
                + (wrong ? "to see one that went wrong: " : "to see the closest call: ")
                + replay.command(worst)
                + "\n";
    }

    /** What a search has found. */
    public static String found(WorstSearch search, RunAgain replay) {
        String what = "%s %s".formatted(search.which(), search.search().measure());
        String unknown =
                search.unknown() == 0
                        ? ""
                        : ", %,d of them without such a number,".formatted(search.unknown());
        return search.worst()
                .map(
                        worst ->
                                "the %s that a search of %,d runs%s has found is %s: %s\n"
                                        .formatted(
                                                what,
                                                search.runs(),
                                                unknown,
                                                number(worst.value()),
                                                replay.command(worst.row())))
                .orElse(
                        "the %s: none of the %,d runs of the search has such a number\n"
                                .formatted(what, search.runs()));
    }
}
