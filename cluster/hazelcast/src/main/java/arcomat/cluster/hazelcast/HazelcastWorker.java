package arcomat.cluster.hazelcast;

import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.Meeting;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.pipeline.campaign.engine.WorkerPlan;

import com.hazelcast.client.HazelcastClient;
import com.hazelcast.core.HazelcastInstance;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/** The worker's side: waits for campaigns, and makes their runs one campaign after the other. */
final class HazelcastWorker {
    /** How often it looks whether a campaign has begun. */
    private static final int LOOK_MILLIS = 300;

    /**
     * Who is to end with a campaign waits so long for more of it: a search for the worst run
     * follows the runs, and one that was killed goes on.
     */
    private static final long LAST_NANOS = TimeUnit.SECONDS.toNanos(10);

    private final WorkerPlan plan;
    private final Consumer<String> told;
    private @Nullable Prepared last;
    private String said = "";

    /** A campaign that comes again, as after {@code --resume}, is not prepared again. */
    private record Prepared(String campaign, TrialRunner runner) {}

    HazelcastWorker(WorkerPlan plan, Consumer<String> told) {
        this.plan = plan;
        this.told = told;
    }

    void work() {
        try {
            Optional<HazelcastInstance> hazelcast = await(Long.MAX_VALUE);
            while (hazelcast.isPresent()) {
                try {
                    serve(hazelcast.get());
                } finally {
                    hazelcast.get().getLifecycleService().terminate();
                }
                hazelcast = await(plan.once() ? LAST_NANOS : Long.MAX_VALUE);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Connects as soon as there is somebody who answers to the cluster's name.
     *
     * @param patience in nanoseconds
     * @return none if nobody came in that time
     */
    private Optional<HazelcastInstance> await(long patience) throws InterruptedException {
        Meeting meeting = plan.meeting();
        long begun = System.nanoTime();
        while (System.nanoTime() - begun < patience) {
            if (isOpen(meeting)) {
                try {
                    return Optional.of(
                            HazelcastClient.newHazelcastClient(Settings.worker(meeting)));
                } catch (IllegalStateException e) {
                    say(
                            "what listens at "
                                    + meeting.address()
                                    + " does not know cluster '"
                                    + meeting.name()
                                    + "': another name, or another secret; still waiting");
                }
            } else {
                say(
                        "waiting for a campaign of cluster '"
                                + meeting.name()
                                + "' at "
                                + meeting.address());
            }
            Thread.sleep(LOOK_MILLIS);
        }
        return Optional.empty();
    }

    /** What it does not change is not said again. */
    private void say(String what) {
        if (!what.equals(said)) {
            told.accept(what);
            said = what;
        }
    }

    private static boolean isOpen(Meeting meeting) {
        try (Socket socket = new Socket()) {
            socket.connect(new InetSocketAddress(meeting.host(), meeting.port()), 2000);
            return true;
        } catch (IOException e) {
            return false;
        }
    }

    /** Makes runs until the campaign is over, or its process gone: from here that is the same. */
    private void serve(HazelcastInstance hazelcast) throws InterruptedException {
        try {
            Board board = Board.of(hazelcast);
            Optional<Board.Notice> notice = board.read();
            while (notice.isEmpty()) { // it has only just begun
                Thread.sleep(20);
                notice = board.read();
            }
            requireSameVersion(notice.get(), board);
            Shift shift = new Shift(board, notice.get(), plan.threads());
            shift.greet();
            say("campaign " + notice.get().campaign());
            long made = shift.work(runner(notice.get(), board));
            say("campaign " + notice.get().campaign() + " is over, " + made + " runs made here");
        } catch (IllegalStateException | com.hazelcast.core.HazelcastException gone) {
            say("the campaign at " + plan.meeting().address() + " is gone");
        }
    }

    private void requireSameVersion(Board.Notice notice, Board board) {
        if (!notice.version().equals(plan.version())) {
            board.letters(notice).add(LetterText.of(new Letter.Refusal(plan.version())));
            throw new EngineFailure(
                    "the campaign at "
                            + plan.meeting().address()
                            + " is made by version "
                            + notice.version()
                            + " of the tool, and this worker is version "
                            + plan.version()
                            + ": start one of version "
                            + notice.version());
        }
    }

    private TrialRunner runner(Board.Notice notice, Board board) {
        if (last == null || !last.campaign().equals(notice.campaign())) {
            last = new Prepared(notice.campaign(), new TrialRunner(freight(notice, board)));
        }
        return last.runner();
    }

    private static Freight freight(Board.Notice notice, Board board) {
        try {
            byte[] packed = board.goods().get(notice.campaign());
            Freight freight = Freight.unpacked(packed == null ? new byte[0] : packed);
            if (freight.hash().equals(notice.campaign())) {
                return freight;
            }
            throw new EngineFailure("the campaign's content is not what it says it is");
        } catch (IOException e) {
            throw new EngineFailure("the campaign's content cannot be read: " + e.getMessage());
        }
    }
}
