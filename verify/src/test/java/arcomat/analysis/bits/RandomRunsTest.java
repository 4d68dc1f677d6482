package arcomat.analysis.bits;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.RandomQuestion;
import arcomat.analysis.refinement.Sides;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** What is said to hold of Doubles, holds in runs. */
class RandomRunsTest {
    private static final int QUESTIONS = 12;
    private static final int FIRST = 1_000;
    private static final int RUNS = 60;

    @Tag("slow")
    @Test
    void whatHoldsHoldsInRuns() {
        int holds = 0;
        for (int seed = FIRST; seed < FIRST + QUESTIONS; seed++) {
            List<String> texts = new RandomQuestion(seed, true).models();
            Sides sides = Sides.of(texts);
            if (sides.check(new Budget(() -> false, 10_000)).answer() == Answer.HOLDS) {
                holds++;
                for (int run = 0; run < RUNS; run++) {
                    RandomRun.follow(sides, new Random(run), "seed " + seed + ": " + texts);
                }
            }
        }
        assertThat(holds).isGreaterThan(QUESTIONS / 4);
    }
}
