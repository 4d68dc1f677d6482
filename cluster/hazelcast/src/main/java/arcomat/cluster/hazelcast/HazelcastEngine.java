package arcomat.cluster.hazelcast;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.cluster.hazelcast.Letter.Answers;
import arcomat.cluster.hazelcast.Letter.Breakdown;
import arcomat.cluster.hazelcast.Letter.Hello;
import arcomat.cluster.hazelcast.Letter.Refusal;
import arcomat.pipeline.campaign.engine.Answer;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.Meeting;
import arcomat.pipeline.campaign.engine.TrialBytes;

import com.hazelcast.client.Client;
import com.hazelcast.collection.IQueue;
import com.hazelcast.core.Hazelcast;
import com.hazelcast.core.HazelcastException;
import com.hazelcast.core.HazelcastInstance;
import com.hazelcast.core.HazelcastInstanceNotActiveException;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/** The campaign's side: gives out trials, and reads the letters of workers. */
final class HazelcastEngine implements Engine {
    /** How often it looks who is still there. */
    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(200);

    private final Freight freight;
    private final Consumer<String> told;
    private final HazelcastInstance hazelcast;
    private final Board board;
    private final Board.Notice notice;
    private final IQueue<byte[]> letters;
    private final Dispatch dispatch = new Dispatch();
    private final Map<UUID, Integer> numbers = new HashMap<>();
    private final List<Row> rows = new ArrayList<>();
    private long looked = System.nanoTime();

    private HazelcastEngine(
            Freight freight,
            Consumer<String> told,
            HazelcastInstance hazelcast,
            Board board,
            Board.Notice notice) {
        this.freight = freight;
        this.told = told;
        this.hazelcast = hazelcast;
        this.board = board;
        this.notice = notice;
        this.letters = board.letters(notice);
    }

    static HazelcastEngine open(Freight freight, Meeting meeting, Consumer<String> told) {
        requireFree(meeting);
        HazelcastInstance hazelcast;
        try {
            hazelcast = Hazelcast.newHazelcastInstance(Settings.campaign(meeting));
        } catch (HazelcastException | IllegalStateException e) {
            throw cannotListen(meeting, e);
        }
        Board board = Board.of(hazelcast);
        HazelcastEngine engine =
                new HazelcastEngine(freight, told, hazelcast, board, board.post(freight));
        told.accept(
                "cluster '"
                        + meeting.name()
                        + "' waits for workers at "
                        + meeting.address()
                        + ": arcomat campaign-worker --cluster "
                        + meeting.name()
                        + " --at "
                        + meeting.address());
        return engine;
    }

    /** The system's own words are better than those of whoever passes them on. */
    private static void requireFree(Meeting meeting) {
        try (ServerSocket socket = new ServerSocket()) {
            socket.setReuseAddress(true);
            socket.bind(
                    new java.net.InetSocketAddress(
                            InetAddress.getByName(meeting.host()), meeting.port()));
        } catch (IOException e) {
            throw cannotListen(meeting, e);
        }
    }

    private static EngineFailure cannotListen(Meeting meeting, Exception e) {
        return new EngineFailure(
                "cannot listen at "
                        + meeting.address()
                        + ": "
                        + e.getMessage()
                        + "; give another address of this machine, or another port, with --at");
    }

    @Override
    public int capacity() {
        return Math.max(1, dispatch.threads());
    }

    @Override
    public void submit(List<Trial> batch) {
        dispatch.submit(batch);
        assign();
    }

    private void assign() {
        for (Dispatch.Batch each : dispatch.assign()) {
            board.trials(notice, each.worker()).add(TrialBytes.of(each.trials()));
        }
    }

    @Override
    public List<Row> collect(Duration patience) {
        try {
            long end = System.nanoTime() + patience.toNanos();
            look();
            byte[] letter = letters.poll(patience.toNanos(), TimeUnit.NANOSECONDS);
            while (letter != null) {
                read(letter);
                boolean waits = rows.isEmpty() && System.nanoTime() < end;
                letter = letters.poll(waits ? end - System.nanoTime() : 0, TimeUnit.NANOSECONDS);
            }
            assign();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new EngineFailure("interrupted");
        } catch (HazelcastInstanceNotActiveException e) {
            throw new EngineFailure(
                    "the cluster has stopped, " + e.getMessage() + "; go on with --resume");
        }
        List<Row> collected = List.copyOf(rows);
        rows.clear();
        return collected;
    }

    /**
     * Who is gone is seen by looking who is there, not by being told: a worker may be gone before
     * its first letter is read.
     */
    private void look() {
        if (System.nanoTime() - looked < LOOK_NANOS) {
            return;
        }
        looked = System.nanoTime();
        Set<UUID> present =
                hazelcast.getClientService().getConnectedClients().stream()
                        .map(Client::getUuid)
                        .collect(Collectors.toSet());
        for (UUID worker : dispatch.workers()) {
            if (!present.contains(worker)) {
                leave(worker);
            }
        }
    }

    private void leave(UUID worker) {
        Dispatch.Loss loss = dispatch.leave(worker);
        board.trials(notice, worker).destroy();
        String given =
                switch (loss.again()) {
                    case 0 -> "";
                    case 1 -> "; 1 run is made by others";
                    default -> "; " + loss.again() + " runs are made by others";
                };
        told.accept("worker " + numbers.get(worker) + " is gone" + given);
        loss.givenUp().forEach(this::giveUp);
    }

    /** The same words whoever was lost: they are a part of the table. */
    private void giveUp(Trial trial) {
        String why = "%d workers were lost with it".formatted(Dispatch.LOSSES);
        rows.add(Row.withoutAnswers(trial, Row.Ending.GIVEN_UP, why));
        told.accept("run %d is given up: %s".formatted(trial.number(), why));
    }

    private void read(byte[] bytes) {
        @Nullable Letter letter = letter(bytes);
        if (letter != null) {
            letter.match(this::welcome, this::take, this::refused, this::broken);
        }
    }

    private static @Nullable Letter letter(byte[] bytes) {
        try {
            return LetterText.letter(bytes);
        } catch (IOException e) {
            return null; // not of a worker: there is nobody to tell
        }
    }

    private Void welcome(Hello hello) {
        int number = numbers.computeIfAbsent(hello.worker(), id -> numbers.size() + 1);
        dispatch.join(hello.worker(), hello.threads());
        assign();
        told.accept(
                "worker %d has come, process %d, %d %s"
                        .formatted(
                                number,
                                hello.process(),
                                hello.threads(),
                                hello.threads() == 1 ? "thread" : "threads"));
        return null;
    }

    private Void take(Answers answers) {
        for (Answer each : answers.rows()) {
            dispatch.answer(answers.worker(), each.number())
                    .ifPresent(trial -> rows.add(each.row(trial)));
        }
        return null;
    }

    private Void refused(Refusal refusal) {
        told.accept(
                "a worker of version "
                        + refusal.version()
                        + " does not take part: this is version "
                        + freight.version());
        return null;
    }

    private Void broken(Breakdown breakdown) {
        throw new EngineFailure(
                "worker " + numbers.get(breakdown.worker()) + " cannot go on: " + breakdown.why());
    }

    @Override
    public String crew() {
        int workers = dispatch.workers().size();
        int threads = dispatch.threads();
        return "%d %s, %d %s"
                .formatted(
                        workers,
                        workers == 1 ? "worker" : "workers",
                        threads,
                        threads == 1 ? "thread" : "threads");
    }

    /** Nothing has to be saved, and nobody to be waited for. */
    @Override
    public void close() {
        hazelcast.getLifecycleService().terminate();
    }
}
