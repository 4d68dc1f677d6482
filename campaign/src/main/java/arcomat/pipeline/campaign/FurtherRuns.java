package arcomat.pipeline.campaign;

import arcomat.campaign.RareEvent;
import arcomat.campaign.WorstSearch;
import arcomat.campaign.coverage.Coverage;
import arcomat.campaign.coverage.CoverageCount;
import arcomat.campaign.coverage.CoverageItems;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.ShownRows;

import java.util.Optional;
import java.util.function.Function;

/**
 * Makes the runs of a campaign that its table does not have: those of a search, and those of a
 * splitting.
 *
 * @param engines starts who makes the runs
 */
public record FurtherRuns(PrepareCampaign.Ready ready, Function<Freight, Engine> engines)
        implements Task<FurtherRuns.Found> {
    /**
     * What came of them.
     *
     * @param worst empty where the campaign has no search, or that found nothing
     * @param rare empty where the campaign has no splitting
     * @param coverage of the automata of its robots, by these runs
     */
    public record Found(Optional<WorstSearch> worst, Optional<RareEvent> rare, Coverage coverage) {
        /** Where there were no further runs. */
        public static Found nothing(CoverageItems items) {
            Coverage none = new CoverageCount(items).coverage();
            return new Found(Optional.empty(), Optional.empty(), none);
        }
    }

    /**
     * @throws WrongUse where runs cannot go on
     */
    @Override
    public Found run(Session session) throws WrongUse {
        CoverageCount count = new CoverageCount(ready.items());
        Function<Freight, Engine> counted =
                engines.andThen(engine -> new ShownRows(engine, row -> count.see(row.reached())));
        Optional<WorstSearch> worst = session.run(new SearchWorst(ready, counted));
        Optional<RareEvent> rare = session.run(new SplitRuns(ready, counted));
        return new Found(worst, rare, count.coverage());
    }
}
