package arcomat.models;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.Cli;
import arcomat.cli.terminal.Console;
import arcomat.pipeline.brick.ForwardingObserver;
import arcomat.sim.Laboratory;
import arcomat.sim.SimulatedBrick;
import arcomat.sim.device.Key;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.SilentObserver;
import arcomat.sim.device.Stimulus;
import arcomat.sim.load.Program;
import arcomat.sim.load.ProgramException;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.IntStream;

/** What the library's components do with devices, seen on the simulated brick. */
class LibraryOnBrickTest {
    private static final Path FOLDER = Path.of("src/test/resources/library");

    @TempDir Path out;

    /**
     * Readings are scaled and cut off, a colour is known by its name, wheels add speed and turn, a
     * timer keeps its rate, and the display changes where something new is to be seen.
     */
    @Tag("slow")
    @Test
    void devicesAndComponentsUnderstandEachOther() throws IOException {
        arcomat(
                "generate",
                "--target",
                "lejos",
                "--main",
                "robots.Devices",
                "--out",
                out + "/o",
                ".");
        String trace =
                arcomat("run-brick", "--jar", out + "/o/Devices.jar", "--script", "devices.script");

        assertThat(trace).isEqualTo(Files.readString(FOLDER.resolve("devices.trace")));
    }

    /**
     * Of each type a message; nobody waits while the other robot is not there yet, or goes away.
     */
    @Tag("slow")
    @Test
    void robotsTalk() throws Exception {
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick caller = laboratory.place("Alice", program("Caller"));
            caller.expose(SensorName.S1, Stimulus.value(77));
            laboratory.runUntil(7000);
            SimulatedBrick answerer = laboratory.place("Bob", program("Answerer"));
            laboratory.runUntil(30000);
            assertThat(answerer.screen()).startsWith("              77", "halt", "released");
            assertThat(caller.screen().get(0)).isEqualTo("halt");

            caller.press(Key.ENTER);
            laboratory.runUntil(35000);
            assertThat(answerer.screen()).startsWith("              77", "go", "pressed");
            assertThat(caller.screen().get(0)).isEqualTo("go");

            answerer.stop();
            laboratory.runUntil(40000);
            assertThat(caller.isRunning()).isTrue();
        }
    }

    /** Packets may arrive in parts; each slice sends a number, and each number is seen. */
    @Tag("slow")
    @Test
    void noMessageIsLost() throws Exception {
        Set<String> shown = new HashSet<>();
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick caller = laboratory.place("Alice", program("Caller"));
            SimulatedBrick answerer = laboratory.place("Bob", program("Answerer"));
            laboratory.runUntil(3000);
            answerer.observe(
                    new ForwardingObserver(new SilentObserver()) {
                        @Override
                        public void slept(long from, long until) {
                            shown.add(answerer.screen().get(0).strip());
                        }
                    });
            for (int distance = 1; distance <= 60; distance++) {
                caller.expose(SensorName.S1, Stimulus.value(distance));
                laboratory.runUntil(laboratory.time() + 100);
            }
            laboratory.runUntil(laboratory.time() + 1000);
        }
        assertThat(shown).containsAll(IntStream.rangeClosed(1, 60).mapToObj(i -> "" + i).toList());
    }

    private Program program(String robot) throws IOException, ProgramException {
        String folder = out + "/" + robot;
        arcomat("generate", "--target", "lejos", "--main", "robots." + robot, "--out", folder, ".");
        return Program.read(Path.of(folder, robot + ".jar"));
    }

    private static String arcomat(String... words) {
        StringWriter text = new StringWriter();
        Console console =
                Console.quiet(
                        FOLDER.toAbsolutePath(),
                        new PrintWriter(text),
                        new PrintWriter(Writer.nullWriter()),
                        new BufferedReader(new StringReader("")));
        int status = Cli.run(words, console);
        assertThat(status).as(text.toString()).isZero();
        return text.toString();
    }
}
