package arcomat.fuzz;

import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.Tag;
import net.jqwik.api.statistics.Statistics;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * Models that are nearly good: no stage fails, none is slow, none lets pass what breaks the next.
 */
class DamagedModelsTest {
    /** Much more than a busy machine needs for the slowest; less than for ever. */
    private static final Duration PATIENCE = Duration.ofMinutes(2);

    private static final List<ModelSet> SETS =
            List.of(
                    ModelSet.folder("coffee", Path.of("models/coffee")),
                    ModelSet.folder("truth", Path.of("src/test/resources/truth")),
                    ModelSet.page("language", Path.of("docs/language.md")));
    private static final List<Harmless> LAWS = SETS.stream().map(Harmless::new).toList();

    @Tag("slow")
    @Property(
            seed = "1",
            tries = 120,
            shrinking = ShrinkingMode.OFF,
            edgeCases = EdgeCasesMode.NONE)
    void damaged(@ForAll long seed) {
        check(seed, set -> new Damage(SETS, seed).apply(set));
    }

    @Tag("slow")
    @Property(seed = "2", tries = 80, shrinking = ShrinkingMode.OFF, edgeCases = EdgeCasesMode.NONE)
    void varied(@ForAll long seed) {
        check(seed, set -> new Variation(seed).apply(set));
    }

    private static void check(long seed, UnaryOperator<ModelSet> change) {
        int number = Math.floorMod(seed, SETS.size());
        ModelSet original = SETS.get(number);
        ModelSet changed = change.apply(original);
        try {
            Harmless.Stage reached =
                    assertTimeoutPreemptively(PATIENCE, () -> LAWS.get(number).check(changed));
            Statistics.label("reached").collect(reached);
        } catch (RuntimeException | Error problem) {
            throw new AssertionError(
                    "seed " + seed + "\n" + changed.differenceFrom(original), problem);
        }
    }
}
