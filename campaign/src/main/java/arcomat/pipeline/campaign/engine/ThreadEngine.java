package arcomat.pipeline.campaign.engine;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;

import org.jspecify.annotations.Nullable;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;

/** Threads of this process. */
public final class ThreadEngine implements Engine {
    private final int threads;
    private final Function<Trial, Row> runner;
    private final ExecutorService crew;
    private final LinkedBlockingQueue<Row> ready = new LinkedBlockingQueue<>();
    private volatile @Nullable Throwable broken;

    /**
     * @param threads how many trials at a time
     * @param runner makes a run; is called by several threads at once
     */
    public ThreadEngine(int threads, Function<Trial, Row> runner) {
        this.threads = threads;
        this.runner = runner;
        this.crew =
                Executors.newFixedThreadPool(
                        threads,
                        body -> {
                            Thread thread = new Thread(body, "campaign");
                            thread.setDaemon(true); // a command that is interrupted ends
                            return thread;
                        });
    }

    @Override
    public int capacity() {
        return threads;
    }

    @Override
    public void submit(List<Trial> batch) {
        batch.forEach(trial -> crew.execute(() -> make(trial)));
    }

    private void make(Trial trial) {
        try {
            ready.add(runner.apply(trial));
        } catch (RuntimeException | Error e) {
            broken = e;
        }
    }

    /** What breaks a run here is a fault of ours, and would be one in every run. */
    @Override
    public List<Row> collect(Duration patience) {
        long end = System.nanoTime() + patience.toNanos();
        List<Row> rows = new ArrayList<>();
        while (rows.isEmpty() && broken == null && System.nanoTime() < end) {
            takeOne(rows);
        }
        if (broken != null) {
            throw new IllegalStateException(broken);
        }
        ready.drainTo(rows);
        return rows;
    }

    private void takeOne(List<Row> rows) {
        try {
            Row row = ready.poll(10, TimeUnit.MILLISECONDS);
            if (row != null) {
                rows.add(row);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new EngineFailure("interrupted");
        }
    }

    @Override
    public String crew() {
        return threads == 1 ? "1 thread" : threads + " threads";
    }

    @Override
    public void close() {
        crew.shutdownNow();
    }
}
