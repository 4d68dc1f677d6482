package arcomat.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

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

/** Models that are nearly good: no stage fails, none is slow, none lets pass what breaks the next. */
class DamagedModelsTest {
    /** A hundred times what the slowest needs on an idle machine. */
    private static final Duration PATIENCE = Duration.ofSeconds(30);

    private static final List<ModelSet> SETS =
            List.of(
                    ModelSet.folder("coffee", Path.of("models/coffee")),
                    ModelSet.folder("truth", Path.of("src/test/resources/truth")),
                    ModelSet.page("language", Path.of("docs/language.md")));
    private static final List<Harmless> LAWS = SETS.stream().map(Harmless::new).toList();

    @Property(tries = 120, shrinking = ShrinkingMode.OFF, edgeCases = EdgeCasesMode.NONE)
    void damaged(@ForAll long seed) {
        check(seed, set -> new Damage(SETS, seed).apply(set));
    }

    @Property(tries = 80, shrinking = ShrinkingMode.OFF, edgeCases = EdgeCasesMode.NONE)
    void varied(@ForAll long seed) {
        check(seed, set -> new Variation(seed).apply(set));
    }

    @Tag("slow")
    @Property(tries = 3000, shrinking = ShrinkingMode.OFF, edgeCases = EdgeCasesMode.NONE)
    void damagedOftener(@ForAll long seed) {
        check(seed, set -> new Damage(SETS, seed).apply(set));
    }

    @Tag("slow")
    @Property(tries = 3000, shrinking = ShrinkingMode.OFF, edgeCases = EdgeCasesMode.NONE)
    void variedOftener(@ForAll long seed) {
        check(seed, set -> new Variation(seed).apply(set));
    }

    private static void check(long seed, UnaryOperator<ModelSet> change) {
        int number = Math.floorMod(seed, SETS.size());
        ModelSet original = SETS.get(number);
        long start = System.nanoTime();
        ModelSet changed = change.apply(original);
        try {
            Statistics.label("reached").collect(LAWS.get(number).check(changed));
        } catch (RuntimeException | Error problem) {
            throw new AssertionError(
                    "seed " + seed + "\n" + changed.differenceFrom(original), problem);
        }
        assertThat(Duration.ofNanos(System.nanoTime() - start)).isLessThan(PATIENCE);
    }
}
