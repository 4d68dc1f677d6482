package arcomat.cluster.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import arcomat.cli.Embedded;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * By the Spark that SPARK_HOME names, skipped where it names none: in one process, and with a
 * master and two workers on this machine. What is printed and kept is that of threads.
 */
@Tag("slow")
@Timeout(900)
class SparkSubmitTest {
    private static final String HOME = System.getenv("SPARK_HOME");
    private static final int RUNS = 600;

    @TempDir private Path temporary;
    private Processes processes;

    @BeforeEach
    void requireSpark() throws IOException {
        assumeTrue(HOME != null, "SPARK_HOME names no Spark");
        processes =
                new Processes(
                        temporary,
                        Map.of("SPARK_LOCAL_IP", "127.0.0.1", "SPARK_DAEMON_MEMORY", "256m"));
        Questions.write(temporary);
        Path world = Path.of(System.getProperty("models"), "world", "meeting.world");
        Files.writeString(
                temporary.resolve("yard.campaign"),
                "world " + world + "\nsample random " + RUNS + "\n");
    }

    @AfterEach
    void endAll() {
        if (processes != null) {
            processes.close();
        }
    }

    private List<String> submit(String master, String... settings) {
        List<String> command =
                new ArrayList<>(List.of(program("spark-submit"), "--master", master));
        List<String> all =
                new ArrayList<>(
                        List.of(
                                "spark.driver.bindAddress=127.0.0.1",
                                "spark.driver.host=127.0.0.1",
                                "spark.ui.enabled=false",
                                "spark.log.level=WARN"));
        all.addAll(List.of(settings));
        all.forEach(each -> command.addAll(List.of("--conf", each)));
        command.addAll(List.of("--class", SparkCampaign.class.getName()));
        command.add(System.getProperty("spark.jar"));
        return command;
    }

    private static String program(String name) {
        return Path.of(HOME, "bin", name).toString();
    }

    private List<String> yard(List<String> command, String... options) {
        List<String> all = new ArrayList<>(command);
        all.add("yard.campaign");
        all.addAll(List.of(options));
        return all;
    }

    /** What the command says in this process. */
    private String ofThreads(String... arguments) throws InterruptedException {
        StringWriter out = new StringWriter();
        PrintWriter err = new PrintWriter(out);
        Embedded.run(temporary, new PrintWriter(out), err, arguments);
        return out.toString();
    }

    /** The address of a master with two workers, a core each. */
    private String cluster() throws Exception {
        String serving = "org.apache.spark.deploy.";
        processes.start(
                "master",
                List.of(
                        program("spark-class"),
                        serving + "master.Master",
                        "--host",
                        "127.0.0.1",
                        "--port",
                        "0",
                        "--webui-port",
                        "0"));
        String line = processes.awaitLine("master.err", each -> each.contains(" at spark://"));
        String master = line.replaceAll(".*(spark://\\S+).*", "$1");
        for (String each : List.of("first", "second")) {
            processes.start(each, worker(serving, each, master));
            processes.awaitLine(
                    each + ".err", said -> said.contains("Successfully registered with master"));
        }
        return master;
    }

    private List<String> worker(String serving, String name, String master) {
        return List.of(
                program("spark-class"),
                serving + "worker.Worker",
                "--host",
                "127.0.0.1",
                "--webui-port",
                "0",
                "--cores",
                "1",
                "--memory",
                "1g",
                "--work-dir",
                temporary.resolve("of-" + name).toString(),
                master);
    }

    /** Stops early, then searches, then splits: three engines, one after the other. */
    @Test
    void everyKindOfQuestionHasTheSameAnswer() throws Exception {
        List<String> command = Questions.asked(submit("local[2]"), "--out", "out");
        int status = processes.start("spark", command).waitFor();
        assertThat(status).as(processes.output("spark.err")).isZero();
        assertThat(processes.output("spark"))
                .isEqualTo(ofThreads("campaign", "questions.campaign", "--out", "out"));
        assertThat(processes.output("spark.err")).containsOnlyOnce(" makes the runs, at local[2]");
    }

    @Test
    void executorsAreKilled() throws Exception {
        List<String> command = yard(submit(cluster()), "--out", "out");
        Process campaign = processes.start("spark", command);
        processes.awaitLine("out/rows.unfinished", line -> line.startsWith(RUNS / 10 + ","));
        assertThat(executors()).hasSize(2);
        executors().get(0).destroyForcibly();
        processes.awaitLine("out/rows.unfinished", line -> line.startsWith(RUNS / 2 + ","));
        executors().get(0).destroyForcibly();
        assertThat(campaign.waitFor()).as(processes.output("spark.err")).isZero();
        assertThat(processes.output("spark.err")).contains("Lost executor");
        String rows = Files.readString(temporary.resolve("out/rows.csv"));
        assertThat(rows.lines()).hasSize(RUNS + 1);
        assertThat(processes.output("spark"))
                .isEqualTo(
                        ofThreads("campaign", "yard.campaign", "--out", "threads")
                                .replace(", in threads", ", in out"))
                .contains("table ");
        assertThat(temporary.resolve("threads/rows.csv")).hasContent(rows);
    }

    /** Processes that workers of this test have started, oldest first. */
    private static List<ProcessHandle> executors() {
        return ProcessHandle.current()
                .descendants()
                .filter(each -> each.info().commandLine().orElse("").contains("ExecutorBackend"))
                .sorted()
                .toList();
    }

    @Test
    void theDriverIsKilledAndResumed() throws Exception {
        String master = cluster();
        Process killed = processes.start("killed", yard(submit(master), "--out", "out"));
        processes.awaitLine("out/rows.unfinished", line -> line.startsWith(RUNS / 10 + ","));
        killed.destroyForcibly().waitFor();
        List<String> command = yard(submit(master), "--out", "out", "--resume");
        int status = processes.start("spark", command).waitFor();
        assertThat(status).as(processes.output("spark.err")).isZero();
        ofThreads("campaign", "yard.campaign", "--out", "threads");
        assertThat(temporary.resolve("out/rows.csv"))
                .hasSameTextualContentAs(temporary.resolve("threads/rows.csv"));
    }

    /** A cluster that has a jar of the tool among its own. */
    @Test
    void anExecutorOfAnotherVersionIsRefused() throws Exception {
        Files.writeString(temporary.resolve("arcomat-version.txt"), "0.0.9\n");
        String other = "spark.executor.extraClassPath=" + temporary;
        List<String> command = yard(submit(cluster(), other), "--out", "out");
        assertThat(processes.start("spark", command).waitFor()).isEqualTo(2);
        assertThat(processes.output("spark.err"))
                .containsPattern(
                        "(?m)^arcomat: an executor has version 0\\.0\\.9 of arcomat, and the"
                                + " campaign is made by version \\S+: look for another jar");
    }
}
