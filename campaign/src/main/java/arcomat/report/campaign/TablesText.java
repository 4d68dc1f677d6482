package arcomat.report.campaign;

import arcomat.campaign.CampaignResult.Occurrence;
import arcomat.campaign.against.FinishedTable;
import arcomat.campaign.against.TableDifference;
import arcomat.campaign.statistics.Decision;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;

import java.util.List;

/** How a table differs from an older one, for people. */
public final class TablesText {
    private final TablesReport report;
    private final TableDifference difference;
    private final Style style;

    public TablesText(TablesReport report, Style style) {
        this.report = report;
        this.difference = report.difference();
        this.style = style;
    }

    public String render() {
        StringBuilder text = new StringBuilder("\n" + head() + "\n\n" + events() + "\n");
        if (!difference.measures().isEmpty()) {
            text.append(measures()).append('\n');
        }
        report.remarks().forEach(each -> text.append(Printable.escape(each)).append('\n'));
        for (TableDifference.OfEvent each : difference.events()) {
            if (each.decision() != Decision.UNDECIDED) {
                text.append(line(each)).append('\n');
            }
        }
        if (difference.events().stream().allMatch(e -> e.decision() == Decision.UNDECIDED)) {
            text.append("no event is shown to be better or worse\n");
        }
        return text.toString();
    }

    private String head() {
        FinishedTable before = report.before();
        return Printable.escape(
                "against %s: %,d runs, table %s; %,d are runs of both"
                        .formatted(
                                before.name(), before.runs(), before.hash(), difference.pairs()));
    }

    private String events() {
        TextTable table = new TextTable(List.of("event", "before", "now", "better in", "worse in"));
        for (TableDifference.OfEvent each : difference.events()) {
            table.add(
                    List.of(
                            each.now().column().name(),
                            share(each.before()),
                            share(each.now()),
                            "%,d".formatted(each.changes().better()),
                            "%,d".formatted(each.changes().worse())));
        }
        return table.render(style);
    }

    private static String share(Occurrence occurrence) {
        return "%,d of %,d".formatted(occurrence.runs(), occurrence.known());
    }

    private String measures() {
        TextTable table =
                new TextTable(
                        List.of("median", "before", "now", "greater in", "smaller in", "differs"));
        for (TableDifference.OfMeasure each : difference.measures()) {
            table.add(
                    List.of(
                            each.now().column().name(),
                            CampaignText.number(each.before().median()),
                            CampaignText.number(each.now().median()),
                            "%,d".formatted(each.greater()),
                            "%,d".formatted(each.smaller()),
                            each.differs() ? "yes" : ""));
        }
        return table.render(style);
    }

    private String line(TableDifference.OfEvent event) {
        boolean isBetter = event.decision() == Decision.HOLDS;
        String word = isBetter ? style.good("better: ") : style.error("worse: ");
        return word + Printable.escape(event.now().column().name());
    }
}
