package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.RareEvent;
import arcomat.campaign.SplitCourse;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;

import java.util.Optional;
import java.util.function.Function;

/**
 * Makes the runs of a splitting, where a campaign asks for it: those of a level when all of the one
 * before are there.
 *
 * @param engines starts who makes the runs
 */
public record SplitRuns(PrepareCampaign.Ready ready, Function<Freight, Engine> engines)
        implements Task<Optional<RareEvent>> {
    /**
     * Empty where the campaign does not ask for it.
     *
     * @throws WrongUse where runs cannot go on
     */
    @Override
    public Optional<RareEvent> run(Session session) throws WrongUse {
        if (ready.campaign().split().isEmpty()) {
            return Optional.empty();
        }
        Campaign.Split split = ready.campaign().split().get();
        try (Engine engine = engines.apply(ready.freight())) {
            SplitCourse course = SplitCourse.start(ready.campaign(), split);
            for (int level = 0; !course.isOver(); level++) {
                String shown = "to %,d mm".formatted(split.levels().get(level));
                RowsInOrder rows = new RowsInOrder(engine, session, shown);
                course = course.next(rows.of(course.trials()));
            }
            return Optional.of(course.result());
        } catch (EngineFailure e) {
            throw new WrongUse("%s", String.valueOf(e.getMessage()));
        }
    }
}
