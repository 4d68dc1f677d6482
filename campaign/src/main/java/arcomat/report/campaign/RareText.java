package arcomat.report.campaign;

import arcomat.campaign.RareEvent;
import arcomat.campaign.statistics.Confidence;
import arcomat.campaign.statistics.ConfidenceInterval;
import arcomat.campaign.statistics.Splitting.Level;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;

import java.util.List;

/**
 * What a splitting says, for people: its levels, the probability, and the run that came nearest.
 */
public final class RareText {
    private final RareEvent event;
    private final RunAgain replay;
    private final Style style;

    public RareText(RareEvent event, RunAgain replay, Style style) {
        this.event = event;
        this.replay = replay;
        this.style = style;
    }

    public String render() {
        return "\n" + levels() + "\n" + answer() + "\n" + nearest();
    }

    private String levels() {
        TextTable table = new TextTable(List.of("level", "runs", "reached", "share"));
        for (int i = 0; i < event.levels().size(); i++) {
            Level level = event.levels().get(i);
            double share = (double) level.reached() / level.started();
            table.add(
                    List.of(
                            "%,d mm".formatted(event.split().levels().get(i)),
                            "%,d".formatted(level.started()),
                            "%,d".formatted(level.reached()),
                            CampaignText.number(share)));
        }
        return table.render(style);
    }

    private String answer() {
        String asked = "%s of %,d mm".formatted(event.split().measure(), event.event());
        if (event.givenUp() > 0) {
            return "%s: not known, as %,d of %,d runs were given up"
                    .formatted(asked, event.givenUp(), event.runs());
        }
        if (!event.isKnown()) {
            return asked + ": not known, as too few runs have a world";
        }
        ConfidenceInterval interval = event.interval(Confidence.USUAL);
        if (event.families().count() == 0) {
            return "%s: none of %,d runs came there; probability surely (95 %%) at most %s"
                    .formatted(asked, event.runs(), CampaignText.number(interval.high()));
        }
        return "%s: probability %s, surely (95 %%) %s to %s, by %,d runs; %,d families came there"
                .formatted(
                        asked,
                        CampaignText.number(event.estimate()),
                        CampaignText.number(interval.low()),
                        CampaignText.number(interval.high()),
                        event.runs(),
                        event.families().count());
    }

    private String nearest() {
        return event.nearest()
                .map(
                        each ->
                                "the nearest came to %s mm: %s\n"
                                        .formatted(
                                                CampaignText.number(each.millimetres()),
                                                replay.command(each.row())))
                .orElse("");
    }
}
