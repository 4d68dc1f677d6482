package arcomat.report.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignResult;
import arcomat.campaign.Judgement;
import arcomat.campaign.RareEvent;
import arcomat.campaign.WorstSearch;
import arcomat.campaign.coverage.Coverage;
import arcomat.campaign.overview.Overview;
import arcomat.campaign.statistics.Decision;
import arcomat.report.page.Page.Tone;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * A campaign that has come to its end, for whoever wants to know.
 *
 * @param file of the campaign, as the user wrote it
 * @param campaign what was asked
 * @param replay how its runs are made again
 * @param result what came of it
 * @param coverage of the automata of its robots
 * @param worst what a search has found; empty where there was none
 * @param rare what a splitting says; empty where there was none
 * @param planned how many runs it could have had: less where the answer was clear before
 * @param table what tells its table from any other
 * @param against the table beside older ones
 */
public record CampaignReport(
        String file,
        Campaign campaign,
        RunAgain replay,
        CampaignResult result,
        Overview overview,
        Coverage coverage,
        Optional<WorstSearch> worst,
        Optional<RareEvent> rare,
        long planned,
        String table,
        List<TablesReport> against) {
    public CampaignReport {
        against = List.copyOf(against);
    }

    /** The same beside older tables. */
    public CampaignReport against(List<TablesReport> older) {
        return new CampaignReport(
                file, campaign, replay, result, overview, coverage, worst, rare, planned, table,
                older);
    }

    /** Whether something fails, or is worse than before. */
    public boolean fails() {
        return result.fails() || isWorse();
    }

    private boolean isWorse() {
        return against.stream().anyMatch(each -> each.difference().isWorse());
    }

    /** How many rows the table has. */
    public long runs() {
        return result.made() + result.impossible() + result.givenUp();
    }

    /** How good news it is. */
    Tone tone() {
        if (fails()) {
            return Tone.BAD;
        }
        if (result.isOpen()) {
            return Tone.OPEN;
        }
        return demands(each -> true) == 0 ? Tone.NEUTRAL : Tone.GOOD;
    }

    /** What came of it, in a sentence. */
    public String headline() {
        String runs = "%,d %s of %s".formatted(runs(), runs() == 1 ? "run" : "runs", world());
        return runs + ": " + verdict();
    }

    private String world() {
        return replay.world();
    }

    private String verdict() {
        long all = demands(each -> true);
        long failed = demands(each -> each.decision() == Decision.FAILS);
        long open = demands(each -> each.decision() == Decision.UNDECIDED);
        if (failed > 0) {
            return "%,d of %,d requirements fail".formatted(failed, all)
                    + (open > 0 ? ", %,d not decided".formatted(open) : "");
        }
        if (result.fails()) {
            return "the new one is worse";
        }
        if (isWorse()) {
            return "something is worse than before";
        }
        if (open > 0) {
            return "%,d of %,d requirements not decided".formatted(open, all);
        }
        return all == 0
                ? "nothing was required"
                : all == 1 ? "what is required holds" : "all %,d requirements hold".formatted(all);
    }

    private long demands(Predicate<Judgement> which) {
        return result.judgements().stream().filter(Judgement::isDemand).filter(which).count();
    }
}
