package arcomat.pipeline.campaign;

import arcomat.campaign.Trials;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.file.Failures;

import java.io.IOException;
import java.util.function.Function;

/**
 * Makes the runs of one part of a campaign and keeps their rows, which nobody judges yet.
 *
 * @param ready what to run
 * @param results the folder for the rows, as the user wrote it
 * @param resumes whether rows that the folder has are kept
 * @param engines starts who makes the runs
 */
public record MakePart(
        PrepareCampaign.Ready ready,
        CampaignPart part,
        String results,
        boolean resumes,
        Function<Freight, Engine> engines)
        implements Task<MakePart.Made> {
    /**
     * What was made.
     *
     * @param first number of the first run
     * @param end the number behind the last one
     */
    public record Made(long first, long end) {}

    /**
     * @throws WrongUse where rows cannot be written, or are another campaign's or part's
     */
    @Override
    public Made run(Session session) throws WrongUse {
        Trials trials = Trials.of(ready.campaign());
        long first = part.first(trials.count());
        long end = part.end(trials.count());
        String owner = PartRows.owner(ready.freight().hash(), first, end);
        try (ResultFolder folder = ResultFolder.of(results, session.names());
                RowFile rows = folder.rows(ready.campaign(), owner, resumes, row -> {});
                Engine engine = engines.apply(ready.freight())) {
            new RunCourse(trials, first, end, rows, engine, row -> {}, () -> false).run(session);
            folder.keepPart();
            return new Made(first, end);
        } catch (EngineFailure e) {
            throw new WrongUse("%s", String.valueOf(e.getMessage()));
        } catch (IOException e) {
            throw Failures.cannot("write to", results, e);
        }
    }
}
