package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.terminal.Console;

import org.junit.jupiter.api.Test;

import java.io.BufferedReader;
import java.io.PrintWriter;
import java.io.Reader;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Path;

/** Whatever goes wrong in the tool is told, and no script takes it for success. */
class InternalErrorTest {
    private final StringWriter err = new StringWriter();

    /** A fault of the tool, at the first word it says. */
    private static final class Broken extends PrintWriter {
        Broken() {
            super(Writer.nullWriter());
        }

        @Override
        public void write(String text) {
            throw new NoClassDefFoundError("a/Part");
        }

        @Override
        public void write(String text, int from, int length) {
            write(text);
        }
    }

    @Test
    void anErrorOfJavaIsToldAsOne() {
        Console console =
                Console.quiet(
                        Path.of(""),
                        new Broken(),
                        new PrintWriter(err),
                        new BufferedReader(Reader.nullReader()));
        assertThat(Cli.run(new String[] {"explain", "ARC0104"}, console)).isEqualTo(2);
        assertThat(err.toString())
                .startsWith("arcomat: internal error, this is a fault of arcomat")
                .contains("NoClassDefFoundError: a/Part")
                .doesNotContain("\tat ");
    }
}
