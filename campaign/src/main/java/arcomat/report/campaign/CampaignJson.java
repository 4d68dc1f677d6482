package arcomat.report.campaign;

import arcomat.report.text.Json;

/**
 * The result of a campaign for programs. Shares are from 0 to 1, distances in mm, times in seconds;
 * a number that is none, or infinite, is left out. Intervals are those of Clopper and Pearson, two
 * sides, 95 %.
 */
public final class CampaignJson {
    private CampaignJson() {}

    /** All but the maps over two parameters, which are for people's eyes. */
    public static String render(CampaignReport report) {
        return Json.text(CampaignAnswer.of(report));
    }
}
