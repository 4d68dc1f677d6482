package arcomat.fuzz.process;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;

/** A few damaged inputs of each kind; {@code ./gradlew fuzz} takes as many as there is time for. */
@Tag("distribution")
class DamagedInputTest {
    private static final int INPUTS = 10;

    @TempDir private Path folder;

    @Test
    void noDamageIsAnErrorOfTheTool() throws Exception {
        try (FuzzRun run = new FuzzRun(20261122, "", folder)) {
            for (Kind kind : run.tallies().keySet()) {
                for (int i = 0; i < INPUTS; i++) {
                    run.once(kind);
                }
                assertThat(run.tallies().get(kind).processes).as(kind.name()).isPositive();
            }
            assertThat(run.findings()).isEmpty();
        }
    }

    /** A finding can be looked at again. */
    @Test
    void aSeedTellsTheInputs() throws Exception {
        try (FuzzRun run = new FuzzRun(7, "scripts|states|jars|targets", folder)) {
            for (Kind kind : run.tallies().keySet()) {
                Input input = run.input(kind, 3);
                Input again = run.input(kind, 3);
                Input next = run.input(kind, 4);
                assertThat(again.calls()).isEqualTo(input.calls());
                assertThat(contents(again)).isEqualTo(contents(input));
                assertThat(contents(next)).isNotEqualTo(contents(input));
            }
        }
    }

    private static Map<String, Integer> contents(Input input) {
        Map<String, Integer> contents = new TreeMap<>();
        input.files().forEach((path, file) -> contents.put(path, Arrays.hashCode(file)));
        return contents;
    }
}
