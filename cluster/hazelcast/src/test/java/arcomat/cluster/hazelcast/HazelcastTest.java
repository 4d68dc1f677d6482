package arcomat.cluster.hazelcast;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.PrepareCampaign;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.EngineProvider;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.Meeting;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.pipeline.campaign.engine.WorkerPlan;
import arcomat.sim.device.Limits;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.LongStream;

/** Campaign and workers in one process, on a world with two lamps that are watched together. */
@Tag("slow")
@Timeout(180)
class HazelcastTest {
    private static final Freight FREIGHT = freight();

    private final EngineProvider provider =
            ServiceLoader.load(EngineProvider.class).findFirst().orElseThrow();
    private final List<String> told = new CopyOnWriteArrayList<>();
    private final List<String> toldWorker = new CopyOnWriteArrayList<>();

    /** Programs are made once. */
    private static Freight freight() {
        Path folder = Path.of("../../campaign/src/test/resources/campaign/joint").toAbsolutePath();
        Session session = new Session(new PathNames(folder), Progress.NONE);
        PrepareCampaign task =
                new PrepareCampaign(
                        "yard.campaign", Limits.OF_THE_BRICK, Duration.ofMinutes(1), "1.0");
        try {
            return session.run(task).ready().orElseThrow().freight();
        } catch (WrongUse e) {
            throw new IllegalStateException(e);
        }
    }

    /** The same world, which is over sooner. */
    private static Freight shorter(int seconds) {
        return new Freight(
                FREIGHT.version(),
                FREIGHT.campaign(),
                FREIGHT.world().replace("seconds 9", "seconds " + seconds),
                FREIGHT.limited(),
                FREIGHT.patience(),
                FREIGHT.programs(),
                FREIGHT.monitors(),
                FREIGHT.joint(),
                FREIGHT.coverage());
    }

    private static Meeting meeting(String name, String secret) throws IOException {
        try (ServerSocket free = new ServerSocket(0)) {
            return new Meeting(name, secret, "127.0.0.1", free.getLocalPort());
        }
    }

    private Thread worker(Meeting meeting, String version) {
        WorkerPlan plan = new WorkerPlan(meeting, 2, version, false);
        Thread thread = new Thread(() -> tryToWork(plan));
        thread.start();
        return thread;
    }

    private void tryToWork(WorkerPlan plan) {
        try {
            provider.work(plan, toldWorker::add);
        } catch (EngineFailure e) {
            toldWorker.add("failed: " + e.getMessage());
        }
    }

    private static List<Trial> trials(long from, long to) {
        return LongStream.range(from, to).mapToObj(i -> new Trial(i, i, Map.of())).toList();
    }

    private static List<Row> collect(Engine engine, int size) {
        List<Row> rows = new ArrayList<>();
        while (rows.size() < size) {
            rows.addAll(engine.collect(Duration.ofMillis(100)));
        }
        rows.sort(Comparator.comparing(row -> row.trial().number()));
        return rows;
    }

    private static void await(List<String> lines, String part) throws InterruptedException {
        while (lines.stream().noneMatch(line -> line.contains(part))) {
            Thread.sleep(20);
        }
    }

    @Test
    void oneWorkerServesOneCampaignAfterTheOther() throws Exception {
        Meeting meeting = meeting("yard", "");
        Thread worker = worker(meeting, "1.0");
        for (int seconds : List.of(1, 2)) {
            Freight freight = shorter(seconds);
            List<Row> here = trials(0, 300).stream().map(new TrialRunner(freight)).toList();
            assertThat(here).allMatch(Row::wasMade);
            try (Engine engine = provider.open(freight, meeting, told::add)) {
                assertThat(engine.capacity()).isEqualTo(1);
                engine.submit(trials(0, 300));
                assertThat(collect(engine, 300)).isEqualTo(here);
                assertThat(engine.crew()).isEqualTo("1 worker, 2 threads");
                assertThat(engine.capacity()).isEqualTo(2);
            }
            await(toldWorker, "campaign " + freight.hash() + " is over, 300 runs made here");
        }
        worker.interrupt();
        worker.join();
        assertThat(told.get(0))
                .isEqualTo(
                        "cluster 'yard' waits for workers at %s: arcomat campaign-worker"
                                        .formatted(meeting.address())
                                + " --cluster yard --at "
                                + meeting.address());
    }

    @Test
    void anotherVersionIsRefusedOnBothSides() throws Exception {
        Meeting meeting = meeting("yard", "");
        try (Engine engine = provider.open(FREIGHT, meeting, told::add)) {
            worker(meeting, "0.9").join();
            assertThat(toldWorker)
                    .last()
                    .isEqualTo(
                            "failed: the campaign at %s is made by version 1.0 of the tool, and"
                                            .formatted(meeting.address())
                                    + " this worker is version 0.9: start one of version 1.0");
            assertThat(engine.collect(Duration.ofSeconds(1))).isEmpty();
            assertThat(told)
                    .last()
                    .isEqualTo("a worker of version 0.9 does not take part: this is version 1.0");
        }
    }

    @Test
    void whoDoesNotKnowTheSecretStaysOutside() throws Exception {
        Meeting meeting = meeting("yard", "sesame");
        Meeting guessed = new Meeting("yard", "barley", meeting.host(), meeting.port());
        try (Engine engine = provider.open(FREIGHT, meeting, told::add)) {
            Thread stranger = worker(guessed, "1.0");
            await(toldWorker, "does not know cluster 'yard': another name, or another secret");
            stranger.interrupt();
            stranger.join();
            assertThat(engine.crew()).isEqualTo("0 workers, 0 threads");
            assertThat(told).hasSize(1);
        }
    }

    @Test
    void twoCampaignsDoNotMeetAtOneAddress() throws Exception {
        Meeting meeting = meeting("yard", "");
        try (Engine engine = provider.open(FREIGHT, meeting, told::add)) {
            assertThatThrownBy(() -> provider.open(FREIGHT, meeting, told::add))
                    .isInstanceOf(EngineFailure.class)
                    .hasMessageMatching(
                            "cannot listen at %s: Address already in use.*; give another .* --at"
                                    .formatted(meeting.address()));
            assertThat(engine.collect(Duration.ZERO)).isEmpty();
        }
    }
}
