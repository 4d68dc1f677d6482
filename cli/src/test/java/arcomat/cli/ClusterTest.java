package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The installed tool as several processes on this machine, which are killed in the middle of their
 * work: nothing is lost, nothing is there twice, the table is that of one process.
 */
@Tag("distribution")
@Timeout(900)
class ClusterTest {
    private static final Path WORLD = Path.of("models/coffee/world/meeting.world").toAbsolutePath();
    private static final int RUNS = 400;
    private static final Pattern TABLE = Pattern.compile("(?m)^table (\\w+)");

    @TempDir private Path temporary;
    private ToolProcesses tool;
    private String address = "";

    @BeforeEach
    void writeCampaign() throws IOException {
        tool = new ToolProcesses(temporary);
        write("yard.campaign", RUNS);
        try (ServerSocket free = new ServerSocket(0)) {
            address = "127.0.0.1:" + free.getLocalPort();
        }
    }

    private void write(String name, int runs) throws IOException {
        Path world = temporary.relativize(WORLD);
        Files.writeString(
                temporary.resolve(name), "world " + world + "\nsample random " + runs + "\n");
    }

    @AfterEach
    void endAll() throws InterruptedException {
        tool.endAll();
    }

    private Process start(String log, String... arguments) throws IOException {
        return tool.start(log, List.of(arguments));
    }

    private Process worker(String log) throws IOException {
        return start(
                log, "campaign-worker", "--cluster", "yard", "--at", address, "--workers", "1");
    }

    private Process campaign(String log, String... more) throws IOException {
        List<String> arguments = new ArrayList<>(List.of("campaign", "yard.campaign"));
        arguments.addAll(List.of(more));
        return start(log, arguments.toArray(String[]::new));
    }

    private Process distributed(String log, String... more) throws IOException {
        List<String> all = new ArrayList<>(List.of("--cluster", "yard", "--at", address));
        all.addAll(List.of(more));
        return campaign(log, all.toArray(String[]::new));
    }

    private String log(String name) throws IOException {
        return tool.log(name);
    }

    private String table(String log) throws IOException {
        Matcher found = TABLE.matcher(log(log));
        assertThat(found.find()).as(log(log)).isTrue();
        return found.group(1);
    }

    private String tableOfThreads() throws Exception {
        assertThat(campaign("threads.log", "--workers", "2").waitFor()).isZero();
        return table("threads.log");
    }

    /** In the middle of its work: so many rows are there. */
    private void awaitRows(int rows) throws Exception {
        while (tool.rows("out") < rows) {
            Thread.sleep(20);
        }
    }

    private void awaitLine(String log, String part) throws Exception {
        while (!log(log).contains(part)) {
            Thread.sleep(20);
        }
    }

    private void assertWholeTable(String log) throws Exception {
        assertThat(table(log)).isEqualTo(tableOfThreads());
        List<String> rows = Files.readAllLines(temporary.resolve("out/rows.csv"));
        assertThat(rows).hasSize(RUNS + 1);
        assertThat(rows.subList(1, rows.size()))
                .extracting(row -> row.substring(0, row.indexOf(',')))
                .containsExactlyElementsOf(
                        java.util.stream.IntStream.range(0, RUNS).mapToObj(i -> "" + i).toList());
    }

    @Test
    void workersAreKilledAndComeLater() throws Exception {
        Process first = worker("first.log");
        Process second = worker("second.log");
        Process campaign = distributed("campaign.log", "--out", "out");
        awaitLine("campaign.log", "worker 2 has come");
        awaitRows(RUNS / 8);
        first.destroyForcibly();
        second.destroyForcibly(); // so that the third has to come before everything is done
        worker("third.log");
        awaitLine("campaign.log", " is gone");
        assertThat(campaign.waitFor()).isZero();
        assertThat(log("campaign.log")).contains("worker 3 has come").doesNotContain("\tat ");
        assertWholeTable("campaign.log");
    }

    @Test
    void theCampaignIsKilledAndTwoOfFourWorkersToo() throws Exception {
        List<Process> workers = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            workers.add(worker("worker" + i + ".log"));
        }
        Process killed = distributed("killed.log", "--out", "out");
        awaitRows(RUNS / 8);
        workers.get(0).destroyForcibly();
        killed.destroyForcibly().waitFor();
        Process resumed = distributed("resumed.log", "--out", "out", "--resume");
        awaitRows(RUNS / 4);
        workers.get(1).destroyForcibly();
        assertThat(resumed.waitFor()).isZero();
        assertWholeTable("resumed.log");
        assertThat(workers.get(2).isAlive() && workers.get(3).isAlive()).isTrue();
        assertThat(log("worker2.log")).contains("is over").doesNotContain("\tat ");
    }

    @Test
    void workersLeftOverFromAnotherCampaignServeThisOne() throws Exception {
        worker("worker.log");
        write("other.campaign", 60);
        Process other =
                start(
                        "other.log",
                        "campaign",
                        "other.campaign",
                        "--cluster",
                        "yard",
                        "--at",
                        address);
        assertThat(other.waitFor()).isZero();
        assertThat(distributed("campaign.log", "--out", "out").waitFor()).isZero();
        assertWholeTable("campaign.log");
    }
}
