package arcomat.analysis.search.packed;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.model.Port;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;

/**
 * Packed configurations of event-driven compositions give the same verdicts as those that are not.
 */
class PackedEventsTest {
    private static final int QUESTIONS = Integer.getInteger("packed.questions", 50);
    private static final int SEED = Integer.getInteger("packed.seed", 41);

    private final PackedComparison comparison = new PackedComparison(1_000);

    @Tag("slow")
    @Test
    void saysTheSameOfEvents() {
        int driven = 0;
        for (int i = 0; i < QUESTIONS; i++) {
            RandomEventNetworks networks = new RandomEventNetworks(SEED + i);
            Promise whole = networks.promise("Whole");
            for (String right : List.of("Any", "Some", "Strict", "Whole")) {
                String text = SEED + i + " " + right + networks;
                boolean packed = comparison.compare(whole, networks.promise(right), text);
                driven += packed && hasLatchedInputs(whole) ? 1 : 0;
            }
        }
        assertThat(comparison.packed(Answer.HOLDS)).isGreaterThan(QUESTIONS / 10);
        assertThat(comparison.packed(Answer.FAILS)).isGreaterThan(QUESTIONS / 3);
        assertThat(comparison.smaller()).isGreaterThan(QUESTIONS / 10);
        assertThat(driven).isGreaterThan(QUESTIONS / 5);
    }

    private static boolean hasLatchedInputs(Promise promise) {
        return promise.component().inputs().stream().anyMatch(Port::latched);
    }
}
