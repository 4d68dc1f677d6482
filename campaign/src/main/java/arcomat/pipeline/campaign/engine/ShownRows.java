package arcomat.pipeline.campaign.engine;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;

import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;

/**
 * An engine whose rows somebody is shown, in whatever order they come.
 *
 * @param engine makes the runs
 * @param seen is shown each row once
 */
public record ShownRows(Engine engine, Consumer<Row> seen) implements Engine {
    @Override
    public int capacity() {
        return engine.capacity();
    }

    @Override
    public void submit(List<Trial> batch) {
        engine.submit(batch);
    }

    @Override
    public List<Row> collect(Duration patience) {
        List<Row> rows = engine.collect(patience);
        rows.forEach(seen);
        return rows;
    }

    @Override
    public String crew() {
        return engine.crew();
    }

    @Override
    public void close() {
        engine.close();
    }
}
