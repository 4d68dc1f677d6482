package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.NaiveEventInclusion;
import arcomat.analysis.NaiveEvents;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.OptionalInt;

/**
 * Verdicts about components that handle events are those of naive enumeration, also where the left
 * side has a port that the right one lacks; and nothing changes where a side is put into a
 * composition of its own.
 */
class RandomEventsTest {
    private static final int DEPTH = 4;
    private static final List<String> BIG = List.of("Big", "AroundBig", "RowBig", "HoldBig");
    private static final List<String> SMALL =
            List.of("Small", "AroundSmall", "RowSmall", "HoldSmall");

    private int holds;
    private int fails;
    private int unknown;
    private int unclear;

    @Tag("slow")
    @Test
    void verdictsAreThoseOfEnumeration() {
        compare(0, 20);
        assertThat(holds).isGreaterThan(25);
        assertThat(fails).isGreaterThan(100);
        assertThat(unknown).as("not decided").isLessThan((holds + fails) / 4);
    }

    @Tag("slow")
    @Test
    void alsoForFurtherOnes() {
        compare(1_000, 1_008);
    }

    private void compare(int from, int to) {
        for (int seed = from; seed < to; seed++) {
            RandomEvents models = new RandomEvents(seed);
            Model model = models.model();
            for (String left : BIG) {
                for (String right : SMALL) {
                    compare(seed, models, promise(model, left), promise(model, right));
                }
            }
            for (String right : List.of("Small", "AroundSmall")) {
                compare(seed, models, promise(model, "Small"), promise(model, right));
                compare(seed, models, promise(model, "AroundSmall"), promise(model, right));
            }
        }
    }

    private static Promise promise(Model model, String name) {
        return Promise.of(model.component("load." + name).orElseThrow(), List.of());
    }

    private void compare(int seed, RandomEvents models, Promise left, Promise right) {
        Verdict verdict = Refinement.check(left, right, new Budget(() -> false, 100_000));
        OptionalInt failure;
        try {
            failure = new NaiveEventInclusion(left, right).shortestFailure(DEPTH);
        } catch (NaiveEvents.Unclear readInside) {
            unclear++;
            return;
        }
        String asked = "%d: %s refines %s".formatted(seed, left.title(), right.title());
        if (verdict.answer() == Answer.UNKNOWN) {
            unknown++;
        } else if (failure.isPresent()) {
            assertThat(verdict.trace())
                    .as(() -> asked + models.text())
                    .hasSize(failure.getAsInt() + 1);
            fails++;
        } else {
            boolean deep = verdict.trace().size() > DEPTH + 1;
            assertThat(verdict.answer() == Answer.HOLDS || deep)
                    .as(() -> asked + models.text())
                    .isTrue();
            holds++;
        }
    }
}
