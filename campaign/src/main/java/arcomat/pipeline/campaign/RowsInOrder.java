package arcomat.pipeline.campaign;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.pipeline.Session;
import arcomat.pipeline.campaign.engine.Engine;

import java.time.Duration;
import java.util.List;
import java.util.TreeMap;

/**
 * Runs that have to be all there before it is known which come next: given out as an engine can
 * take them, and brought in the order of their numbers, as who is quicker decides nothing.
 *
 * @param work what they are made for, as people read it
 */
record RowsInOrder(Engine engine, Session session, String work) {
    /**
     * So many runs are given out for each that can be made at a time: enough for messages of many
     * runs to machines that go on meanwhile, since a message costs more than what it says.
     */
    static final int AHEAD = 64;

    /** Who waits longer than this for a row looks whether somebody wants to stop. */
    static final Duration LOOK = Duration.ofMillis(200);

    /**
     * The rows of these trials.
     *
     * @throws arcomat.pipeline.campaign.engine.EngineFailure where runs cannot go on
     */
    List<Row> of(List<Trial> trials) {
        TreeMap<Long, Row> rows = new TreeMap<>();
        int given = 0;
        while (rows.size() < trials.size()) {
            int ahead = Math.min(trials.size(), rows.size() + AHEAD * engine.capacity());
            if (given < ahead) {
                engine.submit(trials.subList(given, ahead));
                given = ahead;
            }
            engine.collect(LOOK).forEach(row -> rows.put(row.trial().number(), row));
            session.progress().goOn();
            session.progress()
                    .step("%s: %,d of %,d runs".formatted(work, rows.size(), trials.size()));
        }
        return List.copyOf(rows.values());
    }
}
