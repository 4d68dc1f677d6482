package arcomat.sim.script;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.CharRange;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Scripts carry their expectation: after a broken line a comment underlines the place and says the
 * message; what is not expected must not be found.
 */
class ScriptParserTest {
    private static final Path SCRIPTS = Path.of("src/test/scripts");
    private static final Pattern EXPECTATION = Pattern.compile("#( *)(~+) (.*)");

    @ParameterizedTest
    @ValueSource(strings = {"good", "broken", "after-the-end"})
    void errorsAreWhereTheScriptSays(String name) throws IOException {
        String text = Files.readString(SCRIPTS.resolve(name + ".script"));
        assertThat(ScriptParser.parse(text).errors()).isEqualTo(expected(text));
        assertThat(ScriptParser.parse(text).script().isPresent()).isEqualTo(name.equals("good"));
    }

    private static List<ScriptError> expected(String text) {
        List<ScriptError> expected = new ArrayList<>();
        List<String> lines = text.lines().toList();
        for (int i = 0; i < lines.size(); i++) {
            Matcher matcher = EXPECTATION.matcher(lines.get(i));
            if (matcher.matches()) {
                int column = matcher.start(2) + 1;
                expected.add(
                        new ScriptError(i, column, matcher.group(2).length(), matcher.group(3)));
            }
        }
        return expected;
    }

    @Test
    void stepsComeInTheOrderOfTime() throws IOException {
        String text = Files.readString(SCRIPTS.resolve("good.script"));
        String steps =
                ScriptParser.parse(text).script().orElseThrow().steps().stream()
                        .map(step -> step.time() + " " + step.action() + "\n")
                        .collect(Collectors.joining());
        assertThat(steps).isEqualTo(Files.readString(SCRIPTS.resolve("good.steps")));
    }

    @Property(tries = 100)
    void everyErrorIsInsideTheText(
            @ForAll @CharRange(from = ' ', to = '#') @CharRange(from = '0', to = '9')
                    String noise) {
        String text = "0 S1 5\n" + noise + "\n10 S2 " + noise;
        ParsedScript parsed = ScriptParser.parse(text);
        List<String> lines = text.lines().toList();
        assertThat(parsed.script().isPresent()).isEqualTo(parsed.errors().isEmpty());
        for (ScriptError error : parsed.errors()) {
            String line = lines.get(error.line() - 1);
            assertThat(error.column()).isBetween(1, line.length() + 1);
        }
    }
}
