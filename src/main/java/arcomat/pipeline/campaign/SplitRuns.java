package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.RareEvent;
import arcomat.campaign.Row;
import arcomat.campaign.SplitCourse;
import arcomat.campaign.Trial;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;

/**
 * Makes the runs of a splitting, where a campaign asks for it: those of a level when all of the one
 * before are there.
 *
 * @param engines starts who makes the runs
 */
public record SplitRuns(PrepareCampaign.Ready ready, Function<Freight, Engine> engines)
        implements Task<Optional<RareEvent>> {
    /** So many runs are given out for each that can be made at a time. */
    private static final int AHEAD = 8;

    private static final Duration LOOK = Duration.ofMillis(200);

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
                course = course.next(rows(course.trials(), shown, engine, session));
            }
            return Optional.of(course.result());
        } catch (EngineFailure e) {
            throw new WrongUse("%s", String.valueOf(e.getMessage()));
        }
    }

    /** In the order of their numbers: who is quicker decides nothing. */
    private static List<Row> rows(
            List<Trial> trials, String level, Engine engine, Session session) {
        TreeMap<Long, Row> inOrder = new TreeMap<>();
        int given = 0;
        while (inOrder.size() < trials.size()) {
            int ahead = Math.min(trials.size(), inOrder.size() + AHEAD * engine.capacity());
            if (given < ahead) {
                engine.submit(trials.subList(given, ahead));
                given = ahead;
            }
            engine.collect(LOOK).forEach(row -> inOrder.put(row.trial().number(), row));
            session.progress().goOn();
            session.progress()
                    .step("%s: %,d of %,d runs".formatted(level, inOrder.size(), trials.size()));
        }
        return List.copyOf(inOrder.values());
    }
}
