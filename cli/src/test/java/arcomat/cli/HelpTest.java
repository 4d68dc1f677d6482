package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.terminal.Console;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.BufferedReader;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** What every help says, whatever the command. */
class HelpTest {
    /** A line of the list of commands. */
    private static final Pattern COMMAND = Pattern.compile("(?m)^  ([a-z-]+) {2,}[A-Z]");

    @TestFactory
    Stream<DynamicTest> everyHelpTellsTheExitStatus() {
        return COMMAND.matcher(help("--help"))
                .results()
                .map(found -> found.group(1))
                .map(command -> DynamicTest.dynamicTest(command, () -> tellsTheStatus(command)));
    }

    private static void tellsTheStatus(String command) {
        assertThat(help(command, "--help").replaceAll("\\s+", " "))
                .containsPattern("Exit status: 0 [^;]+;.* 2 [^;]+\\. ?$");
    }

    /** Eighty columns, where nobody says how many there are. */
    @TestFactory
    Stream<DynamicTest> everyHelpFits() {
        return COMMAND.matcher(help("--help"))
                .results()
                .map(found -> found.group(1))
                .map(command -> DynamicTest.dynamicTest(command, () -> fits(command)));
    }

    private static void fits(String command) {
        assertThat(help(command, "--help").lines()).allMatch(line -> line.length() <= 80);
    }

    private static String help(String... arguments) {
        StringWriter out = new StringWriter();
        Console console =
                Console.quiet(
                        Path.of(""),
                        new PrintWriter(out),
                        new PrintWriter(out),
                        new BufferedReader(new StringReader("")));
        assertThat(Cli.run(arguments, console)).isZero();
        return out.toString();
    }
}
