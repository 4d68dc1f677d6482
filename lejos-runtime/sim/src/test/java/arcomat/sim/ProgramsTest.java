package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.script.Script;
import arcomat.sim.script.ScriptParser;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * Every program in the folder, run with its script, does what its file of expectations says: lines
 * of time in milliseconds and event, and at the end how the program ended.
 */
class ProgramsTest {
    private static final Path PROGRAMS = Path.of("src/test/programs");
    private static final long LIMIT = 60_000;

    @TestFactory
    Stream<DynamicTest> programsDoWhatIsExpected() throws IOException {
        List<String> names;
        try (Stream<Path> files = Files.list(PROGRAMS)) {
            names =
                    files.map(file -> file.getFileName().toString())
                            .filter(file -> file.endsWith(".expected"))
                            .map(file -> file.replace(".expected", ""))
                            .sorted()
                            .toList();
        }
        assertThat(names).isNotEmpty();
        return names.stream().map(name -> DynamicTest.dynamicTest(name, () -> check(name)));
    }

    private static void check(String name) throws IOException {
        String script = Files.readString(PROGRAMS.resolve(name + ".script"));
        String expected = Files.readString(PROGRAMS.resolve(name + ".expected"));
        assertThat(run(name, script)).isEqualTo(expected);
        assertThat(run(name, script)).as("the same again").isEqualTo(expected);
    }

    private static String run(String name, String script) {
        Script read = ScriptParser.parse(script).script().orElseThrow();
        BrickRun run = BrickRun.of(name, Compiled.file(name), read, LIMIT);
        return TraceText.of(run.trace())
                + "%d %s%n".formatted(run.milliseconds(), run.outcome().kind());
    }
}
