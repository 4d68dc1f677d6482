package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Edit;
import arcomat.analysis.NaiveInclusion;
import arcomat.analysis.NaiveSimulation;
import arcomat.analysis.RandomPairs;
import arcomat.analysis.RandomPairs.Pair;
import arcomat.analysis.Replay;
import arcomat.analysis.Sketch;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;

/** The engine against naive enumeration, and every counterexample against the step relation. */
class NaiveInclusionTest {
    private static final int LENGTH = 5;

    @Test
    void agreesOnAHundredPairs() {
        agree(RandomPairs.any(11, 100));
    }

    @Tag("slow")
    @Test
    void agreesOnAThousandPairs() {
        agree(RandomPairs.any(12, 1_000));
    }

    /** Who chooses earlier may do as much, but no step for step. */
    @Test
    void whatHoldsNeedNotBeASimulation() {
        Random random = new Random(13);
        int unlike = 0;
        for (Pair pair : RandomPairs.any(13, 150)) {
            Optional<Sketch> earlier = Edit.CHOOSE_EARLIER.apply(pair.rightSketch(), random);
            if (earlier.isEmpty()) {
                continue;
            }
            Promise right = Promise.of(earlier.get().component("Earlier"), List.of());
            Verdict verdict = Refinement.check(pair.right(), right, Budget.ofMemory());
            assertThat(verdict.answer()).as(earlier::toString).isEqualTo(Answer.HOLDS);
            boolean simulation = new NaiveSimulation(pair.right(), right).holds();
            assertThat(verdict.simulation()).as(earlier::toString).hasValue(simulation);
            unlike += simulation ? 0 : 1;
        }
        assertThat(unlike).as("hold without a simulation").isGreaterThan(20);
    }

    private static void agree(List<Pair> pairs) {
        int kept = 0;
        int late = 0;
        for (Pair pair : pairs) {
            Verdict verdict = Refinement.check(pair.left(), pair.right(), Budget.ofMemory());
            OptionalInt naive =
                    new NaiveInclusion(pair.left(), pair.right()).shortestFailure(LENGTH);
            assertThat(engine(verdict)).as(pair::toString).isEqualTo(naive);
            if (verdict.answer() == Answer.FAILS) {
                Replay.check(pair.left(), pair.right(), verdict);
                late += verdict.trace().size() > 3 ? 1 : 0;
            } else {
                boolean simulation = new NaiveSimulation(pair.left(), pair.right()).holds();
                assertThat(verdict.simulation()).as(pair::toString).hasValue(simulation);
                kept += verdict.notes().stream().noneMatch(n -> n.startsWith("empty")) ? 1 : 0;
            }
        }
        assertThat(kept).as("hold, not vacuously").isGreaterThan(pairs.size() * 3 / 10);
        assertThat(late).as("fail at length 3 or more").isGreaterThan(pairs.size() * 3 / 10);
    }

    /** The length of the counterexample, if enumeration can have found it. */
    private static OptionalInt engine(Verdict verdict) {
        int length = verdict.trace().size() - 1;
        return verdict.answer() == Answer.FAILS && length <= LENGTH
                ? OptionalInt.of(length)
                : OptionalInt.empty();
    }
}
