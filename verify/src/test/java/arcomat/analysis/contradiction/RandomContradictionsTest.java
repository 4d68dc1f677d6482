package arcomat.analysis.contradiction;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.contradiction.Consistency.Contradiction;
import arcomat.analysis.game.Outcomes;
import arcomat.analysis.game.controller.ControllerChecks;
import arcomat.analysis.game.controller.ControllerReading;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

/** What the engine finds about arbitrary requirements, compared with writing everything out. */
class RandomContradictionsTest {
    private static final int SETS = 350;
    private static final int DEPTH = 6;
    private static final Budget BUDGET = new Budget(() -> false, 1_000_000);

    @Tag("slow")
    @Test
    void whatIsFoundIsTrueAndNothingIsMissed() {
        int contradictions = 0;
        int late = 0;
        for (int seed = 0; seed < SETS; seed++) {
            Promise promise = RequirementSets.of(seed);
            Consistency found = Contradictions.check(promise, false, BUDGET);
            assertThat(found.answer()).as("seed %d", seed).isNotEqualTo(Answer.UNKNOWN);
            if (found.answer() == Answer.HOLDS) {
                boolean lost = new Outcomes(promise.each()).isLost(DEPTH);
                assertThat(lost).as("seed %d", seed).isFalse();
                ControllerChecks.check(promise, found.controller().orElseThrow());
                continue;
            }
            Contradiction contradiction = found.contradictions().get(0);
            ContradictionsTest.verify(promise, contradiction);
            Optional<List<Letter>> word = contradiction.word();
            contradictions++;
            late += word.isPresent() && word.get().size() > 1 ? 1 : 0;
        }
        assertThat(contradictions).isBetween(SETS / 4, SETS * 3 / 4);
        assertThat(late).isGreaterThan(SETS / 20);
    }

    @Tag("slow")
    @Test
    void whereInputsHaveToDependOnOutputs() {
        int adaptive = 0;
        for (int seed = 0; seed < 2 * SETS; seed++) {
            Promise promise = RequirementSets.layered(seed);
            Consistency found = Contradictions.check(promise, false, BUDGET);
            if (found.answer() == Answer.HOLDS) {
                assertThat(new Outcomes(promise.each()).isLost(4)).as("seed %d", seed).isFalse();
                continue;
            }
            Contradiction contradiction = found.contradictions().get(0);
            ContradictionsTest.verify(promise, contradiction);
            adaptive += contradiction.word().isEmpty() ? 1 : 0;
        }
        assertThat(adaptive).isGreaterThan(5);
    }

    @Tag("slow")
    @Test
    void controllersAreReadBack() {
        int read = 0;
        for (int seed = 0; seed < SETS / 3; seed++) {
            Promise promise = RequirementSets.of(seed);
            Optional<Component> controller =
                    Contradictions.check(promise, false, BUDGET).controller();
            if (controller.isPresent()) {
                ControllerReading.check(promise.component(), controller.get());
                read++;
            }
        }
        assertThat(read).isGreaterThan(SETS / 12);
    }

    /** Conditions are put together anew from the kinds of messages that the requirements know. */
    @Tag("slow")
    @Test
    void controllersCompareAsTheirRequirementsDo() {
        int guarded = 0;
        for (int seed = 0; seed < SETS / 8; seed++) {
            Promise promise = Comparisons.of(seed);
            Optional<Component> controller =
                    Contradictions.check(promise, false, BUDGET).controller();
            if (controller.isPresent()) {
                ControllerChecks.keepsAll(promise, controller.get());
                ControllerReading.check(promise.component(), controller.get());
                guarded +=
                        ControllerReading.text(controller.get(), promise.component())
                                        .text()
                                        .contains(" [")
                                ? 1
                                : 0;
            }
        }
        assertThat(guarded).isGreaterThan(SETS / 32);
    }

    @Test
    void allMinimalSubsetsAreFound() {
        for (int seed = 0; seed < SETS / 3; seed++) {
            Promise promise = RequirementSets.of(seed);
            Consistency found = Contradictions.check(promise, true, BUDGET);
            List<List<Promise>> cores =
                    found.contradictions().stream()
                            .map(
                                    c ->
                                            promise.each().stream()
                                                    .filter(
                                                            p ->
                                                                    c.requirements()
                                                                            .contains(
                                                                                    p.automata()
                                                                                            .get(
                                                                                                    0)))
                                                    .toList())
                            .toList();
            int size = promise.each().size();
            for (int mask = 1; mask < 1 << size; mask++) {
                List<Promise> subset = subset(promise, mask);
                boolean expected = cores.stream().anyMatch(subset::containsAll);
                if (!expected) {
                    assertThat(new Outcomes(subset).isLost(DEPTH)).as("seed %d", seed).isFalse();
                }
            }
            found.contradictions().forEach(each -> ContradictionsTest.verify(promise, each));
        }
    }

    private static List<Promise> subset(Promise promise, int mask) {
        List<Promise> each = promise.each();
        return java.util.stream.IntStream.range(0, each.size())
                .filter(i -> (mask >> i & 1) == 1)
                .mapToObj(each::get)
                .toList();
    }
}
