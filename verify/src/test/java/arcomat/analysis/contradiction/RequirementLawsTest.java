package arcomat.analysis.contradiction;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.contradiction.RequirementLaws.Kind;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.EnumMap;
import java.util.Map;

/** The laws about requirements for arbitrary ones: some always the same, others new every time. */
class RequirementLawsTest {
    private static final int FEW = 60;
    private static final int MANY = 20;

    @Tag("slow")
    @Test
    void hold() {
        Map<Kind, Integer> met = check(90, FEW);
        assertThat(met.keySet())
                .contains(Kind.KEPT, Kind.KEPT_BY_ERRING, Kind.CONTRADICTING, Kind.ADAPTIVE);
    }

    @Test
    @Tag("slow")
    void holdForOthers() {
        long seed = System.nanoTime();
        System.out.println("requirements from seed " + seed + ": " + check(seed, MANY));
    }

    private static Map<Kind, Integer> check(long seed, int count) {
        Map<Kind, Integer> met = new EnumMap<>(Kind.class);
        for (long each = seed; each < seed + count; each++) {
            SourceFile text = RandomRequirements.text(each);
            try {
                met.merge(RequirementLaws.check(RandomRequirements.of(text)), 1, Integer::sum);
            } catch (RuntimeException | AssertionError broken) {
                throw new AssertionError("seed " + each + "\n" + text.text(), broken);
            }
        }
        return met;
    }
}
