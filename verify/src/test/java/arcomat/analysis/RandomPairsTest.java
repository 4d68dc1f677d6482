package arcomat.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomPairs.Pair;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Pairs are worth comparing: enough of them hold for a reason, enough fail late. */
public class RandomPairsTest {
    @Tag("slow")
    @Test
    void aThirdHoldsForAReasonAndAThirdFailsLate() {
        List<Pair> pairs = RandomPairs.any(1, 300);
        int kept = 0;
        int late = 0;
        for (Pair pair : pairs) {
            Verdict verdict = Refinement.check(pair.left(), pair.right(), Budget.ofMemory());
            kept += verdict.answer() == Answer.HOLDS && !isEmpty(verdict) ? 1 : 0;
            late += verdict.answer() == Answer.FAILS && verdict.trace().size() > 3 ? 1 : 0;
        }
        assertThat(kept).as("hold").isGreaterThan(pairs.size() * 3 / 10);
        assertThat(late).as("fail at length 3 or more").isGreaterThan(pairs.size() * 3 / 10);
    }

    /** Whether a verdict holds only because nothing is promised. */
    public static boolean isEmpty(Verdict verdict) {
        return verdict.notes().stream().anyMatch(note -> note.startsWith("empty"));
    }

    @Test
    void theSameSeedGivesTheSamePairs() {
        assertThat(RandomPairs.any(7, 20)).isEqualTo(RandomPairs.any(7, 20));
        assertThat(RandomPairs.any(7, 20)).isNotEqualTo(RandomPairs.any(8, 20));
    }
}
