package arcomat.analysis.search;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Sections;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.VerdictsTest;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.function.LongFunction;

/** Where time or memory end, the answer is unknown, and says how far the search has come. */
class BudgetTest {
    private static final Model MODEL =
            Sections.read(Path.of("verify/src/test/resources/analysis/trace-replay.txt")).model();

    @Test
    void timeEndsInTheMiddle() {
        ends(Budget.TIME, times -> Budget.ofMemory().patient(times));
    }

    @Test
    void memoryEndsInTheMiddle() {
        ends(Budget.MEMORY, BudgetTest::ofMemory);
    }

    /** As if there were none left when it is asked for the time once more. */
    private static Budget ofMemory(long times) {
        long[] asked = {0};
        return new Budget(
                () -> {
                    if (++asked[0] > times) {
                        throw new OutOfMemoryError();
                    }
                    return false;
                },
                Long.MAX_VALUE);
    }

    private static void ends(String reason, LongFunction<Budget> budget) {
        Promise left = VerdictsTest.promise(MODEL, "f.Walks", '-');
        Promise right = VerdictsTest.promise(MODEL, "f.MayBe", '-');
        Set<Long> pairs = new LinkedHashSet<>();
        Verdict verdict = Refinement.check(left, right, budget.apply(0));
        for (long times = 1; verdict.answer() == Answer.UNKNOWN; times++) {
            assertThat(verdict.reason()).isEqualTo(reason);
            pairs.add(verdict.explored().pairs());
            verdict = Refinement.check(left, right, budget.apply(times));
        }
        assertThat(verdict.answer()).isEqualTo(Answer.FAILS);
        assertThat(verdict.explored().pairs()).isEqualTo(6);
        assertThat(pairs).containsExactly(0L, 1L, 2L, 3L, 4L, 5L, 6L);
    }
}
