package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * The installed command as a process: the start script, kills at any moment, the time of a start.
 */
@Tag("distribution")
class InstallationTest {
    /** Of two programs in turn. */
    private static final int ROUNDS = 11;

    private static final Path INSTALLATION = Path.of("build/install/arcomat").toAbsolutePath();
    private static final String MODELS = Path.of("models/coffee").toAbsolutePath().toString();

    @TempDir private Path temporary;

    private record Outcome(int status, String output) {}

    private ProcessBuilder command(Path installation, String... arguments) {
        List<String> command = new ArrayList<>();
        command.add(installation.resolve("bin/arcomat").toString());
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command).directory(temporary.toFile()).redirectErrorStream(true);
    }

    private Outcome run(Path installation, String... arguments) throws Exception {
        return outcome(command(installation, arguments));
    }

    private static Outcome outcome(ProcessBuilder command) throws Exception {
        Process process = command.start();
        String output = new String(process.getInputStream().readAllBytes());
        return new Outcome(process.waitFor(), output);
    }

    @Test
    void runsFromAnyFolderAndThroughALink() throws Exception {
        assertThat(run(INSTALLATION, "check", MODELS).status()).isZero();
        Path link = temporary.resolve("bin/arcomat");
        Files.createDirectories(link.getParent());
        Files.createSymbolicLink(link, INSTALLATION.resolve("bin/arcomat"));
        assertThat(run(temporary, "--version").output()).startsWith("arcomat ");
        assertThat(run(temporary, "chek").status()).isEqualTo(2);
    }

    /** One waits for an answer, and an editor for first findings, while classes are loaded. */
    @Test
    void theArchiveHoldsWhatCommandsAndTheLanguageServerLoad() throws Exception {
        for (String[] each :
                new String[][] {
                    {"arcomat.check.Checks", "check", MODELS},
                    {"arcomat.analysis.game.Game", "contradictions", "coffee.floor.Drive", MODELS},
                    {"arcomat.simulate.test.StreamTests", "test", MODELS},
                    {"arcomat.editor.desk.Desk", "language-server"},
                    {"com.google.gson.Gson", "language-server"}
                }) {
            Path log = temporary.resolve("loaded.txt");
            ProcessBuilder command =
                    command(
                            INSTALLATION,
                            List.of(each).subList(1, each.length).toArray(String[]::new));
            command.environment().put("JAVA_OPTS", "-Xlog:class+load:file=" + log);
            command.redirectInput(Path.of("/dev/null").toFile());
            outcome(command);
            assertThat(Files.readAllLines(log))
                    .as(each[0])
                    .anyMatch(line -> line.contains(each[0] + " source: shared objects file"));
        }
    }

    @Test
    void tellsWhoseLibrariesItHolds() throws Exception {
        for (String file : List.of("LICENSE", "NOTICE", "sbom.cdx.json")) {
            assertThat(INSTALLATION.resolve(file)).isNotEmptyFile();
        }
        String bill = Files.readString(INSTALLATION.resolve("sbom.cdx.json"));
        try (Stream<Path> held = Files.walk(INSTALLATION.resolve("lib"))) {
            // What is one jar for Spark consists of libraries that are listed, and lists nothing
            // more.
            Stream<Path> single = held.filter(Files::isRegularFile).filter(file -> !isMerged(file));
            for (Path file : (Iterable<Path>) single::iterator) {
                byte[] content = Files.readAllBytes(file);
                byte[] digest = MessageDigest.getInstance("SHA-256").digest(content);
                assertThat(bill.contains(HexFormat.of().formatHex(digest)))
                        .as(file.toString())
                        .isEqualTo(file.toString().endsWith(".jar"));
            }
        }
    }

    private static boolean isMerged(Path file) {
        return file.endsWith("lib/spark/arcomat-campaign-spark.jar");
    }

    @Test
    void followsAsDeepAsModelsGo() throws Exception {
        StringBuilder classes = new StringBuilder();
        for (int i = 0; i < 1500; i++) {
            classes.append("class C").append(i).append(" { C").append(i + 1).append(" x; }\n");
        }
        Files.writeString(
                temporary.resolve("Deep.cd"),
                "classdiagram Deep {\n" + classes + "class C1500 { int x; } }");
        Files.writeString(
                temporary.resolve("Wall.arc"),
                """
                component Wall {
                  port in Deep.C0 stone, in Boolean knock, out Boolean echo;
                  automaton {
                    state only;
                    initial only;
                    only {knock == ?} / {echo = %sknock%s};
                  }
                }
                """
                        .formatted("(".repeat(900), ")".repeat(900)));
        assertThat(run(INSTALLATION, "check", ".").output()).contains("no findings in 2 files");
        for (String engine : List.of("interpreter", "compiled")) {
            String[] simulate = {"simulate", "--main", "Wall", "--engine", engine, "."};
            assertThat(run(INSTALLATION, simulate).status()).isZero();
        }
        String[] generate = {"generate", "--target", "jvm", "--out", "out", "."};
        assertThat(run(INSTALLATION, generate).status()).isZero();
        assertThat(run(INSTALLATION, "format", "Wall.arc").output()).contains("changed Wall.arc");
    }

    /** Of so many variables conditions are not looked for: only a search is left. */
    @Test
    void noAnalysisDiesOfMemory() throws Exception {
        String big =
                """
                component Big {
                  port in Boolean a, in Boolean b, out Integer[0..9] o;
                  <<completion = "ignore">> automaton {
                    variable Integer[0..1000000] x = 0;
                    variable Integer[0..1000000] y = 0;
                    variable Integer[0..1000000] n0 = 0, n1 = 0, n2 = 0;
                    state s;
                    initial s;
                    s [x < 1000000 && n0 + n1 + n2 == 0] {a == true} / {x = x + 1};
                    s [y < 1000000] {b == true} / {y = y + 1, o = 2};
                    s [x == 1000000 && y == 1000000] {a == false} / {x = 0, o = 3};
                  }
                }
                """;
        Files.writeString(temporary.resolve("Big.arc"), big);
        Files.writeString(temporary.resolve("Same.arc"), big.replace("Big", "Same"));
        String[][] commands = {
            {"refines", "Big", "Same", "Big.arc", "Same.arc"},
            {"diff", "Big", "Same", "Big.arc", "Same.arc"},
            {"tests", "Big", "--out", "tests", "Big.arc"}
        };
        for (String[] command : commands) {
            Outcome outcome = small(command);
            assertThat(outcome.status()).as(outcome.output()).isEqualTo(3);
            assertThat(outcome.output())
                    .contains("memory is full")
                    .doesNotContain("OutOfMemoryError");
        }
    }

    /** In a heap of 64 MB. */
    private Outcome small(String... arguments) throws Exception {
        ProcessBuilder command = command(INSTALLATION, arguments);
        command.environment().put("JAVA_OPTS", "-Xmx64m");
        return outcome(command);
    }

    @Test
    void keepsTheOldFilesWhenKilledWhileWriting() throws Exception {
        String[] generate = {"generate", "--target", "jvm", "--out", "out", MODELS};
        long began = System.nanoTime();
        assertThat(run(INSTALLATION, generate).status()).isZero();
        long duration = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - began);
        List<String> complete = Folders.list(temporary);
        for (int part = 0; part < 6; part++) {
            Process process = command(INSTALLATION, generate).start();
            process.waitFor(duration * (2 + part) / 6, TimeUnit.MILLISECONDS);
            process.destroyForcibly().waitFor();
            assertThat(Folders.list(temporary)).containsAll(complete);
        }
        assertThat(run(INSTALLATION, generate).status()).isZero();
        assertThat(Folders.list(temporary)).isEqualTo(complete);
    }

    /**
     * As the processor sees it: what else the machine does adds to times on the clock, and not
     * evenly. It adds a little to the processor's, too, since caches are shared: so a quarter of
     * the rounds has to show it, not half, and what a busy minute hides may be shown in the next.
     */
    @Test
    void checksTheCoffeeRobotsWithNoMoreWorkThanJavacCompilesASmallClass() throws Exception {
        Path small = temporary.resolve("Small.java");
        Files.writeString(small, "class Small { int twice(int x) { return 2 * x; } }");
        List<Long> checks = new ArrayList<>();
        List<Long> compilations = new ArrayList<>();
        int tries = 0;
        do {
            checks.clear();
            compilations.clear();
            for (int round = 0; round < ROUNDS; round++) {
                checks.add(processorMillis(INSTALLATION + "/bin/arcomat check " + MODELS));
                compilations.add(processorMillis("javac " + small));
            }
            Collections.sort(checks);
            Collections.sort(compilations);
            tries++;
        } while (tries < 3 && checks.get(ROUNDS / 4) > compilations.get(ROUNDS / 2));
        assertThat(checks.get(ROUNDS / 4))
                .as("ms of processor time for check %s and javac %s", checks, compilations)
                .isLessThanOrEqualTo(compilations.get(ROUNDS / 2));
    }

    /** Of a command and all that it starts, for the program and for the system. */
    private long processorMillis(String command) throws Exception {
        ProcessBuilder shell =
                new ProcessBuilder("bash", "-c", "TIMEFORMAT='%U %S'; time " + command + " >&2");
        shell.directory(temporary.toFile()).redirectErrorStream(true);
        Outcome outcome = outcome(shell);
        assertThat(outcome.status()).as(outcome.output()).isZero();
        String[] lines = outcome.output().strip().split("\n");
        double seconds = 0;
        for (String part : lines[lines.length - 1].split(" ")) {
            seconds += Double.parseDouble(part.replace(',', '.'));
        }
        return Math.round(1000 * seconds);
    }
}
