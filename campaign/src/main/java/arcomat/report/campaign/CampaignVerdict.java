package arcomat.report.campaign;

import java.util.List;

/**
 * What a campaign says of what it requires, in the form of JSON: a part of what {@code campaign}
 * itself says, in the same words.
 *
 * @param verdict holds, fails or undecided
 * @param table what tells its table from any other
 */
public record CampaignVerdict(
        String campaign,
        String world,
        String verdict,
        String headline,
        long runs,
        String table,
        List<CampaignAnswer.Verdict> verdicts) {
    public static CampaignVerdict of(CampaignReport report) {
        CampaignAnswer answer = CampaignAnswer.of(report);
        return new CampaignVerdict(
                answer.campaign(),
                answer.world(),
                answer.verdict(),
                answer.headline(),
                answer.runs(),
                answer.table(),
                answer.verdicts());
    }
}
