package arcomat.analysis.search.packed;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.ComparedSystems;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.model.Port;

import org.junit.jupiter.api.Test;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * Packed configurations of event-driven compositions give the very same verdicts as those that are
 * not: texts and numbers.
 */
class PackedEventsTest {
    private static final int QUESTIONS = Integer.getInteger("packed.questions", 100);
    private static final int SEED = Integer.getInteger("packed.seed", 41);
    private static final Budget BUDGET = new Budget(() -> false, 1_000);

    private final Map<Answer, Integer> packed = new EnumMap<>(Answer.class);

    /** Those whose left side has latched inputs. */
    private int driven;

    @Test
    void saysTheSameOfEvents() {
        for (int i = 0; i < QUESTIONS; i++) {
            RandomEventNetworks networks = new RandomEventNetworks(SEED + i);
            for (String right : List.of("Any", "Some", "Strict", "Whole")) {
                Promise promise = networks.promise(right);
                compare(networks.promise("Whole"), promise, SEED + i + " " + right + networks);
            }
        }
        assertThat(packed.get(Answer.HOLDS)).isGreaterThan(QUESTIONS / 10);
        assertThat(packed.get(Answer.FAILS)).isGreaterThan(QUESTIONS / 3);
        assertThat(driven).isGreaterThan(QUESTIONS / 5);
    }

    private void compare(Promise left, Promise right, String text) {
        Verdict quick = Refinement.compare(left, right, BUDGET);
        Verdict thorough =
                Refinement.compare(left, right, BUDGET.with(rule -> rule != Shortcut.PACKED));
        assertThat(quick).as(text).isEqualTo(thorough);
        if (isPacked(left, right)) {
            packed.merge(quick.answer(), 1, Integer::sum);
            driven += left.component().inputs().stream().anyMatch(Port::latched) ? 1 : 0;
        }
    }

    /** Only pairs that are not packed can be told as a certificate. */
    private static boolean isPacked(Promise left, Promise right) {
        TraceInclusion inclusion = ComparedSystems.of(left, right, BUDGET).inclusion(BUDGET);
        inclusion.run();
        return inclusion.certificate().isEmpty();
    }
}
