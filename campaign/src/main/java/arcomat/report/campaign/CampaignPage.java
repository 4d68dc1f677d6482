package arcomat.report.campaign;

import arcomat.diagram.Theme;
import arcomat.report.page.SelfContained;
import arcomat.report.text.Json;
import arcomat.report.text.Printable;

import java.util.List;
import java.util.Map;

/** The result of a campaign as a page: what it proves, how often, where, and what to look at. */
public final class CampaignPage {
    private static final List<String> STYLES =
            List.of("colours.css", "page.css", "campaign/campaign.css");

    private static final List<String> SCRIPTS =
            List.of(
                    "elements.js",
                    "campaign/numbers.js",
                    "campaign/verdicts.js",
                    "campaign/intervals.js",
                    "campaign/histograms.js",
                    "campaign/heat.js",
                    "campaign/runs.js",
                    "campaign/against.js",
                    "campaign/rare.js",
                    "campaign/worst.js",
                    "campaign/coverage.js",
                    "campaign/campaign.js");

    private CampaignPage() {}

    /**
     * What the page reads.
     *
     * @param maps over two parameters each
     */
    private record Data(CampaignAnswer answer, List<MapAnswer> maps) {
        static Data of(CampaignReport report) {
            return new Data(
                    CampaignAnswer.of(report),
                    report.overview().maps().stream().map(MapAnswer::of).toList());
        }
    }

    public static String render(CampaignReport report) {
        Map<String, String> slots =
                Map.of(
                        "title", SelfContained.escaped(report.file()),
                        "headline", SelfContained.escaped(report.headline()),
                        "tone", Printable.word(report.tone()),
                        "data", SelfContained.harmless(Json.compact(Data.of(report))));
        String style = Theme.ADAPTIVE.css() + SelfContained.join(STYLES);
        return SelfContained.render("campaign/campaign.html", style, SCRIPTS, slots);
    }
}
