package arcomat.pipeline.campaign;

import arcomat.campaign.CampaignResult;
import arcomat.campaign.Judge;
import arcomat.campaign.Row;
import arcomat.campaign.Trials;
import arcomat.campaign.coverage.Coverage;
import arcomat.campaign.coverage.CoverageCount;
import arcomat.campaign.overview.Overview;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.file.Failures;
import arcomat.report.campaign.CampaignReport;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * Makes the runs of a campaign and keeps their rows.
 *
 * @param ready what to run
 * @param results the folder for the table, as the user wrote it; empty where only the answer is
 *     wanted
 * @param resumes whether rows that the folder has are kept
 * @param engines starts who makes the runs
 */
public record MakeCampaign(
        PrepareCampaign.Ready ready,
        String results,
        boolean resumes,
        Function<Freight, Engine> engines)
        implements Task<MakeCampaign.Made> {
    /**
     * What was made.
     *
     * @param overview of all rows
     * @param coverage of the automata of its robots, by all rows
     * @param runs how many rows the table has
     * @param planned how many it could have: less where the answer was clear before
     * @param table what tells this table from any other
     */
    public record Made(
            CampaignResult result,
            Overview overview,
            Coverage coverage,
            long runs,
            long planned,
            String table) {
        /**
         * For who shows it.
         *
         * @param file the campaign, as the user wrote it
         * @param made what was run
         * @param further what came of the runs that the table does not have
         */
        public CampaignReport report(
                String file, PrepareCampaign.Ready made, FurtherRuns.Found further) {
            return new CampaignReport(
                    file,
                    made.campaign(),
                    made.replay(),
                    result,
                    overview,
                    coverage.and(further.coverage()),
                    further.worst(),
                    further.rare(),
                    planned,
                    table,
                    List.of());
        }
    }

    /**
     * @throws WrongUse where rows cannot be written, or are another campaign's
     */
    @Override
    public Made run(Session session) throws WrongUse {
        Judge judge = new Judge(ready.campaign());
        CoverageCount count = new CoverageCount(ready.items());
        Consumer<Row> seen =
                row -> {
                    judge.see(row);
                    count.see(row.reached());
                };
        String hash = ready.freight().hash();
        try (ResultFolder folder = ResultFolder.of(results, session.names());
                RowFile rows = folder.rows(ready.campaign(), hash, resumes, seen);
                Engine engine = engines.apply(ready.freight())) {
            Trials trials = Trials.of(ready.campaign());
            new RunCourse(trials, 0, trials.count(), rows, engine, seen, judge::isDecided)
                    .run(session);
            CampaignResult result = judged(judge, rows);
            Overview overview = Overview.of(ready.campaign(), rows::rows);
            folder.keep(rows, new AskedCampaign(hash, ready.freight().campaign()));
            return new Made(
                    result, overview, count.coverage(), rows.count(), trials.count(), rows.hash());
        } catch (EngineFailure e) {
            throw new WrongUse("%s", String.valueOf(e.getMessage()));
        } catch (IOException e) {
            throw Failures.cannot("write to", results, e);
        } catch (UncheckedIOException e) {
            throw Failures.cannot("read from", results, Objects.requireNonNull(e.getCause()));
        }
    }

    private static CampaignResult judged(Judge judge, RowFile rows) throws IOException {
        try (ColumnFiles columns = rows.columns()) {
            return judge.result(columns::measured);
        }
    }
}
