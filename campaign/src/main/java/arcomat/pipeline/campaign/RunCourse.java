package arcomat.pipeline.campaign;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.campaign.Trials;
import arcomat.pipeline.Session;
import arcomat.pipeline.campaign.engine.Engine;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/** The runs of a table, from the first row that is missing to the last. */
final class RunCourse {
    private final Trials trials;
    private final long first;
    private final long end;
    private final RowFile rows;
    private final Engine engine;
    private final Consumer<Row> seen;
    private final BooleanSupplier isDecided;
    private final TreeMap<Long, Row> early = new TreeMap<>();
    private long given;

    /**
     * @param first number of the table's first row
     * @param end the number behind its last one
     * @param rows those that are there
     * @param seen is shown each further one, in the order of their numbers
     * @param isDecided whether no more are wanted
     */
    RunCourse(
            Trials trials,
            long first,
            long end,
            RowFile rows,
            Engine engine,
            Consumer<Row> seen,
            BooleanSupplier isDecided) {
        this.trials = trials;
        this.first = first;
        this.end = end;
        this.rows = rows;
        this.engine = engine;
        this.seen = seen;
        this.isDecided = isDecided;
        this.given = next();
    }

    private long next() {
        return first + rows.count();
    }

    void run(Session session) throws IOException {
        while (next() < end && !isDecided.getAsBoolean()) {
            give();
            engine.collect(RowsInOrder.LOOK).forEach(row -> early.put(row.trial().number(), row));
            keep();
            session.progress().goOn();
            session.progress()
                    .step(
                            "%,d of %,d runs, %s"
                                    .formatted(rows.count(), end - first, engine.crew()));
        }
    }

    private void give() {
        long ahead = (long) RowsInOrder.AHEAD * engine.capacity();
        List<Trial> batch = new ArrayList<>();
        while (given < end && given - next() < ahead) {
            batch.add(trials.trial(given++));
        }
        if (!batch.isEmpty()) {
            engine.submit(batch);
        }
    }

    /** Rows are judged in the order of their numbers: who is quicker decides nothing. */
    private void keep() throws IOException {
        List<Row> fresh = new ArrayList<>();
        long number = next();
        while (!early.isEmpty() && early.firstKey() == number && !isDecided.getAsBoolean()) {
            Row row = early.pollFirstEntry().getValue();
            seen.accept(row);
            fresh.add(row);
            number++;
        }
        rows.add(fresh);
    }
}
