package arcomat.models;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.Cli;
import arcomat.cli.Console;
import arcomat.report.Style;

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

/** What the library's components do with devices, seen on the simulated brick. */
class LibraryOnBrickTest {
    private static final Path FOLDER = Path.of("src/test/resources/library");

    @TempDir Path out;

    /**
     * Readings are scaled and cut off, a colour is known by its name, wheels add speed and turn, a
     * timer keeps its rate, and the display changes where something new is to be seen.
     */
    @Test
    void devicesAndComponentsUnderstandEachOther() throws IOException {
        arcomat("generate", "--target", "lejos", "--main", "robots.Devices", "--out", out + "/o", ".");
        String trace =
                arcomat("run-brick", "--jar", out + "/o/Devices.jar", "--script", "devices.script");

        assertThat(trace).isEqualTo(Files.readString(FOLDER.resolve("devices.trace")));
    }

    private static String arcomat(String... words) {
        StringWriter text = new StringWriter();
        Console console =
                new Console(
                        FOLDER.toAbsolutePath(),
                        new PrintWriter(text),
                        new PrintWriter(Writer.nullWriter()), // progress depends on the machine
                        new BufferedReader(new StringReader("")),
                        Style.PLAIN,
                        false);
        int status = Cli.run(words, console);
        assertThat(status).as(text.toString()).isZero();
        return text.toString();
    }
}
