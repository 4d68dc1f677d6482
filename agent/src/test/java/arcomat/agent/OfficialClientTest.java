package arcomat.agent;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** The installed tool, asked by the client that the makers of the protocol give to everybody. */
@Tag("distribution")
class OfficialClientTest {
    private static final String CLIENT = "mcp==2.3.0";
    private static final Path PYTHON = Path.of("build/agents/mcp-2.3.0/bin/python");
    private static final Path SCRIPT = Path.of("agent/src/test/resources/agent/official_client.py");
    private static final Path TOOL = Path.of("build/install/arcomat/bin/arcomat").toAbsolutePath();
    private static final int SECONDS = 300;

    @TestFactory
    Stream<DynamicTest> client() throws IOException, InterruptedException {
        return isThere()
                ? Stream.of(DynamicTest.dynamicTest("asks for everything", this::asks))
                : Stream.of(
                        DynamicTest.dynamicTest(
                                "skipped: Python, or " + CLIENT + " from PyPI, cannot be had",
                                () -> Assumptions.abort("no client")));
    }

    /** It stays where it was installed once. */
    private static boolean isThere() throws IOException, InterruptedException {
        Path folder = PYTHON.getParent().getParent();
        return answers(PYTHON.toString(), "-c", "import mcp")
                || answers("python3", "-m", "venv", folder.toString())
                        && answers(PYTHON.toString(), "-m", "pip", "install", "-q", CLIENT)
                        && answers(PYTHON.toString(), "-c", "import mcp");
    }

    private static boolean answers(String... command) throws IOException, InterruptedException {
        try {
            return run(command).status() == 0;
        } catch (IOException noSuchProgram) {
            return false;
        }
    }

    private record Outcome(int status, String text) {}

    private static Outcome run(String... command) throws IOException, InterruptedException {
        Path log = Files.createTempFile("client", ".txt");
        try {
            Process process =
                    new ProcessBuilder(command)
                            .redirectErrorStream(true)
                            .redirectOutput(log.toFile())
                            .start();
            boolean ended = process.waitFor(SECONDS, TimeUnit.SECONDS);
            process.destroyForcibly();
            return new Outcome(ended ? process.exitValue() : -1, Files.readString(log));
        } finally {
            Files.delete(log);
        }
    }

    private void asks() throws IOException, InterruptedException {
        Outcome outcome =
                run(PYTHON.toString(), SCRIPT.toString(), TOOL.toString(), "models/coffee");
        assertThat(outcome.text().lines())
                .isEqualTo(
                        List.of(
                                "tools: check diagram explain refines rest simulate test world",
                                "check: 0 errors",
                                "explain: # ARC0104 A port has one sender",
                                "refines: holds",
                                "refines: fails after 3 steps",
                                "simulate: 5 slices",
                                "test: {'passed'}",
                                "diagram: <svg",
                                "world: True",
                                "in parts: True True",
                                "outside: '/etc/passwd' leads out of models/coffee, and nothing"
                                        + " else is read here",
                                "wrong: 'slices' is not a whole number: \"many\""));
        assertThat(outcome.status()).isZero();
    }
}
