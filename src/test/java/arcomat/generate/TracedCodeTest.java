package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Model;
import arcomat.symbols.Scenario;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The code that an engine runs and looks at is the code that users get, with notes: what holds for
 * the one in a run holds for the other.
 */
class TracedCodeTest {
    private static final String NOTE =
            "\\s*|\\s*(private int )?(state|taken)_* = .*;|\\s*private int"
                    + " (state|taken)_*;|\\s*public static final int \\w+ = \\d+;|\\s*/\\*\\* The"
                    + " transition taken last.*";

    @ParameterizedTest
    @ValueSource(
            strings = {"composition", "events", "expressions", "guards", "latched", "mentions"})
    void hasNotesAndNothingElse(String file) {
        Path path = Path.of("src/test/resources/agreement", file + ".txt");
        Model model = Lowering.lower(Scenario.read(path).workspace());
        for (Choosing choosing : Choosing.values()) {
            Request request = Request.all(model, choosing);
            Map<String, String> plain = files(request);
            Map<String, String> traced = files(request.withTrace());
            assertThat(traced.keySet()).isEqualTo(plain.keySet());
            assertThat(traced).isNotEqualTo(plain);
            traced.forEach((name, text) -> hasNotes(name, text, plain.get(name)));
        }
    }

    private static Map<String, String> files(Request request) {
        Map<String, String> files = new TreeMap<>();
        Generation generation = Generator.generate(request, Target.shipped("jvm").orElseThrow());
        assertThat(generation.findings()).isEmpty();
        generation.files().forEach(each -> files.put(each.path(), each.text()));
        return files;
    }

    private static void hasNotes(String name, String traced, String plain) {
        List<String> added = new ArrayList<>();
        Iterator<String> expected = plain.lines().iterator();
        String next = expected.hasNext() ? expected.next() : "";
        for (String line : traced.lines().toList()) {
            if (line.equals(next)) {
                next = expected.hasNext() ? expected.next() : "";
            } else {
                added.add(line);
            }
        }
        assertThat(expected.hasNext()).as(name).isFalse();
        assertThat(added).as(name).allMatch(line -> line.matches(NOTE));
    }
}
