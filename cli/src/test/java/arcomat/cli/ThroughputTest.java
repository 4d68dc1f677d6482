package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import arcomat.cli.Contest.Group;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * How many runs a second a campaign makes, in which way. By the clock that is judged where the
 * variable ARCOMAT_QUIET says that the machine does nothing else: processes of the same program
 * were twice as fast as others there. By the time of processors, with much room, it is judged on
 * any.
 */
@Tag("distribution")
@Timeout(900)
class ThroughputTest {
    private static final Path WORLD = Path.of("models/coffee/world/meeting.world").toAbsolutePath();

    /** More than anybody makes here; the processes are ended. */
    private static final int RUNS = 10_000_000;

    /**
     * Rows of each process until Java has compiled what it needs: a row takes a third less after
     * 20,000 than after 5,000.
     */
    private static final int WARM = 20_000;

    /** The same where a busy machine will not be judged by the clock: there is less to be right. */
    private static final int TEPID = 300;

    @TempDir private Path folder;
    private ToolProcesses tool;
    private boolean judged;

    @BeforeEach
    void writeCampaign() throws Exception {
        assumeTrue(Contest.isPossible(), "not judged: nobody tells how busy the processors are");
        assumeTrue(
                Runtime.getRuntime().availableProcessors() >= 2,
                "not judged: there is one processor");
        tool = new ToolProcesses(folder);
        judged = System.getenv("ARCOMAT_QUIET") != null;
        String world = folder.relativize(WORLD).toString();
        Files.writeString(
                folder.resolve("yard.campaign"),
                "world " + world + "\nsample random " + RUNS + "\n");
    }

    @AfterEach
    void endAll() throws InterruptedException {
        if (tool != null) {
            tool.endAll();
        }
    }

    private Group threads(String name, int count) throws Exception {
        List<String> arguments =
                List.of("campaign", "yard.campaign", "--workers", "" + count, "--out", name);
        return warm(new Group(name, List.of(tool.start(name + ".log", arguments))), 1);
    }

    private Group cluster(String name, int count) throws Exception {
        String address;
        try (ServerSocket free = new ServerSocket(0)) {
            address = "127.0.0.1:" + free.getLocalPort();
        }
        List<String> meeting = List.of("--cluster", "yard", "--at", address);
        List<String> campaign =
                new ArrayList<>(List.of("campaign", "yard.campaign", "--out", name));
        campaign.addAll(meeting);
        List<Process> processes = new ArrayList<>();
        processes.add(tool.start(name + ".log", campaign));
        for (int i = 0; i < count; i++) {
            List<String> worker = new ArrayList<>(List.of("campaign-worker", "--workers", "1"));
            worker.addAll(meeting);
            processes.add(tool.start(name + i + ".log", worker));
        }
        return warm(new Group(name, processes), count);
    }

    private Group warm(Group group, int machines) throws Exception {
        int enough = machines * (judged ? WARM : TEPID);
        while (tool.rows(group.out()) < enough) {
            assertThat(group.processes())
                    .as(tool.log(group.out() + ".log"))
                    .allMatch(Process::isAlive);
            Thread.sleep(200);
        }
        ToolProcesses.signal("STOP", group.processes());
        return group;
    }

    private void judge(String what, Group first, Group second, double byClock, double byProcessors)
            throws Exception {
        Contest contest = new Contest(tool);
        contest.hold(first, second);
        System.out.println(what + ": " + contest);
        assertThat(contest.byProcessors()).as("%s: %s", what, contest).isGreaterThan(byProcessors);
        assumeTrue(
                judged,
                "judged by the clock where ARCOMAT_QUIET says that nobody else works: " + contest);
        assumeTrue(contest.isJudged(), "not judged by the clock: " + contest);
        assertThat(contest.byClock()).as("%s: %s", what, contest).isGreaterThan(byClock);
    }

    @Test
    void twoWorkersAreAsFastAsTwoThreads() throws Exception {
        judge(
                "two workers for two threads",
                threads("threads", 2),
                cluster("cluster", 2),
                0.85,
                0.4);
    }

    /** 0.9 of linear. */
    @Test
    void twoThreadsAreNearlyTwiceAsFastAsOne() throws Exception {
        judge("two threads for one", threads("one", 1), threads("two", 2), 1.8, 0.4);
    }
}
