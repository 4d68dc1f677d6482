package arcomat.cluster.spark;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.TrialBytes;

import org.apache.spark.SimpleFutureAction;
import org.apache.spark.SparkContext;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;
import org.jspecify.annotations.Nullable;

import scala.Function0;
import scala.Function2;
import scala.collection.immutable.Range$;
import scala.runtime.BoxedUnit;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * The driver's side: gives trials to Spark as jobs, a partition for each batch, and takes what each
 * task answers as soon as it is done. The context is Spark's own and ends with the process: a
 * search for the worst run that follows the table uses the same one.
 */
final class SparkEngine implements Engine {
    /** Trials that each core can be given at a time, in tasks. */
    private static final int PER_CORE = 8;

    private final JavaSparkContext spark;
    private final Broadcast<Workshop> workshop;
    private final Backlog backlog = new Backlog();
    private final Map<Long, Trial> wanted = new HashMap<>();
    private final List<SimpleFutureAction<Void>> jobs = new ArrayList<>();
    private final LinkedBlockingQueue<byte[]> ready = new LinkedBlockingQueue<>();

    private SparkEngine(JavaSparkContext spark, Broadcast<Workshop> workshop) {
        this.spark = spark;
        this.workshop = workshop;
    }

    static SparkEngine open(Freight freight, Consumer<String> told) {
        JavaSparkContext spark = context();
        told.accept("Spark " + spark.version() + " makes the runs, at " + spark.master());
        Workshop workshop = new Workshop(freight);
        return new SparkEngine(spark, asked(() -> spark.broadcast(workshop)));
    }

    /** Spark stops by itself, as where its master is gone, and says so by this exception. */
    private static <T> T asked(Supplier<T> question) {
        try {
            return question.get();
        } catch (IllegalStateException stopped) {
            throw new EngineFailure(
                    "Spark has stopped, and its log says why; with --out, go on with --resume");
        }
    }

    /** Scala's exceptions are declared nowhere. */
    private static JavaSparkContext context() {
        try {
            return JavaSparkContext.fromSparkContext(SparkContext.getOrCreate());
        } catch (Exception e) {
            throw new EngineFailure("Spark does not start: " + firstLine(e));
        }
    }

    /** What comes after it are places in Spark's code. */
    private static String firstLine(Throwable e) {
        return String.valueOf(e.getMessage()).lines().findFirst().orElse("");
    }

    private int cores() {
        return Math.max(1, asked(spark::defaultParallelism));
    }

    @Override
    public int capacity() {
        return PER_CORE * cores();
    }

    @Override
    public void submit(List<Trial> batch) {
        batch.forEach(each -> wanted.put(each.number(), each));
        backlog.submit(batch);
        give();
    }

    private void give() {
        List<byte[]> batches = backlog.next(cores()).stream().map(TrialBytes::of).toList();
        if (!batches.isEmpty()) {
            jobs.add(asked(() -> job(batches)));
        }
    }

    private SimpleFutureAction<Void> job(List<byte[]> batches) {
        Function2<Object, byte[], BoxedUnit> take =
                (partition, bytes) -> {
                    ready.add(bytes);
                    return BoxedUnit.UNIT;
                };
        Function0<Void> nothing = () -> null;
        return spark.sc()
                .submitJob(
                        spark.parallelize(batches, batches.size()).rdd(),
                        new MakeRuns(workshop),
                        Range$.MODULE$.apply(0, batches.size()),
                        take,
                        nothing);
    }

    @Override
    public List<Row> collect(Duration patience) {
        List<Row> rows = new ArrayList<>();
        try {
            byte[] first = ready.poll(patience.toNanos(), TimeUnit.NANOSECONDS);
            for (byte[] each = first; each != null; each = ready.poll()) {
                rows.addAll(rows(each));
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new EngineFailure("interrupted");
        }
        requireNoFailure();
        give();
        return rows;
    }

    private List<Row> rows(byte[] bytes) {
        TaskAnswer answer = answer(bytes);
        if (!answer.why().isEmpty()) {
            throw new EngineFailure(answer.why());
        }
        backlog.done(answer.answers().size(), answer.nanoseconds());
        List<Row> rows = new ArrayList<>();
        answer.answers()
                .forEach(
                        each -> {
                            @Nullable Trial trial = wanted.remove(each.number());
                            if (trial != null) {
                                rows.add(each.row(trial));
                            }
                        });
        return rows;
    }

    private static TaskAnswer answer(byte[] bytes) {
        try {
            return TaskAnswer.of(bytes);
        } catch (IOException e) {
            throw new EngineFailure("a task's answer cannot be read: " + e.getMessage());
        }
    }

    /** Spark makes tasks of lost executors again, and gives up after some times. */
    private void requireNoFailure() {
        for (SimpleFutureAction<Void> each : jobs) {
            if (each.isCompleted() && each.value().get().isFailure()) {
                Throwable why = each.value().get().failed().get();
                throw new EngineFailure("Spark gave the runs up: " + firstLine(why));
            }
        }
        jobs.removeIf(SimpleFutureAction::isCompleted);
    }

    @Override
    public String crew() {
        int cores = cores();
        return "Spark, " + (cores == 1 ? "1 core" : cores + " cores");
    }

    /** What was broadcast is dropped by Spark, once no job has it any more. */
    @Override
    public void close() {
        jobs.forEach(SimpleFutureAction::cancel);
    }
}
