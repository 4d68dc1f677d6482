package arcomat.cluster.hazelcast;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.pipeline.campaign.engine.Answer;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.TrialBytes;

import com.hazelcast.collection.IQueue;
import com.hazelcast.core.HazelcastException;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Function;

/** A worker's threads for the time of one campaign: each takes trials, makes them, and answers. */
final class Shift {
    private final Board board;
    private final int threads;
    private final UUID worker;
    private final IQueue<byte[]> trials;
    private final IQueue<byte[]> letters;
    private final AtomicLong made = new AtomicLong();
    private volatile @Nullable EngineFailure failure;

    Shift(Board board, Board.Notice notice, int threads) {
        this.board = board;
        this.threads = threads;
        this.worker = board.hazelcast().getLocalEndpoint().getUuid();
        this.trials = board.trials(notice, worker);
        this.letters = board.letters(notice);
    }

    void greet() {
        long process = ProcessHandle.current().pid();
        letters.add(LetterText.of(new Letter.Hello(worker, threads, process)));
    }

    /**
     * Returns when the campaign's process is gone.
     *
     * @return how many runs were made
     * @throws EngineFailure where a fault of ours keeps it from making runs
     */
    long work(Function<Trial, Row> runner) throws InterruptedException {
        List<Thread> crew = new ArrayList<>();
        for (int i = 0; i < threads; i++) {
            Thread thread = new Thread(() -> loop(runner), "campaign");
            thread.setDaemon(true);
            thread.start();
            crew.add(thread);
        }
        try {
            for (Thread each : crew) {
                each.join();
            }
        } finally {
            crew.forEach(Thread::interrupt);
        }
        if (failure != null) {
            throw failure;
        }
        return made.get();
    }

    private void loop(Function<Trial, Row> runner) {
        try {
            while (board.hazelcast().getLifecycleService().isRunning()) {
                byte[] batch = trials.poll(1, TimeUnit.SECONDS);
                if (batch != null) {
                    letters.add(LetterText.of(make(batch, runner)));
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (HazelcastException | IllegalStateException gone) {
            // The campaign is over, or its process gone: what was not answered is made elsewhere.
        }
    }

    private Letter make(byte[] batch, Function<Trial, Row> runner) {
        try {
            List<Answer> answers = new ArrayList<>();
            for (Trial each : TrialBytes.trials(batch)) {
                answers.add(Answer.of(runner.apply(each)));
                made.incrementAndGet();
            }
            return new Letter.Answers(worker, answers);
        } catch (IOException | RuntimeException | Error e) {
            failure =
                    new EngineFailure("a run could not be made, this is a fault of arcomat: " + e);
            return new Letter.Breakdown(worker, String.valueOf(e));
        }
    }
}
