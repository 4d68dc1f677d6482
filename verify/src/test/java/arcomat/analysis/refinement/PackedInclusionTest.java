package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomNetworks;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.packed.PackedComparison;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Packed configurations give the same verdicts as those that are not. What only packed searches
 * leave out besides is in {@link LeftOutTest}.
 */
class PackedInclusionTest {
    private static final int QUESTIONS = Integer.getInteger("packed.questions", 120);
    private static final int SEED = Integer.getInteger("packed.seed", 19);

    /** Of rows that fail on the level on which they have more states than that. */
    private static final int AT_THE_LIMIT = 403;

    private final PackedComparison comparison = new PackedComparison(3_000);

    @Tag("slow")
    @Test
    void saysTheSameOfNetworks() {
        RandomNetworks networks = new RandomNetworks(SEED);
        for (int i = 0; i < QUESTIONS; i++) {
            RandomNetworks.Question question = networks.question();
            comparison.compare(question.left(), question.right(), question.text());
        }
        assertThat(comparison.packed(Answer.HOLDS)).isGreaterThan(QUESTIONS / 30);
        assertThat(comparison.packed(Answer.FAILS)).isGreaterThan(QUESTIONS / 30);
    }

    /** Parts of one kind share the widths of their fields: those once did not fit the tables. */
    @Tag("slow")
    @Test
    void saysTheSameOfRows() {
        for (int i = 0; i < QUESTIONS / 4; i++) {
            RandomRows rows = new RandomRows(SEED + i);
            compareWhole(rows, "Any");
            compareWhole(rows, "Some");
        }
        assertThat(comparison.packed(Answer.HOLDS)).isGreaterThan(QUESTIONS / 30);
        assertThat(comparison.packed(Answer.FAILS)).isGreaterThan(QUESTIONS / 30);
    }

    /** Where the right side may be in several configurations at once. */
    @Tag("slow")
    @Test
    void saysTheSameAmongSets() {
        for (int i = 0; i < QUESTIONS; i++) {
            RandomRows rows = i % 3 == 0 ? RandomRows.equal(SEED + i) : new RandomRows(SEED + i);
            comparison.compare(rows.whole("Whole"), rows.whole("Several"), rows.toString());
        }
        assertThat(comparison.packed(Answer.HOLDS)).isGreaterThan(QUESTIONS / 30);
        assertThat(comparison.packed(Answer.FAILS)).isGreaterThan(QUESTIONS / 30);
        assertThat(comparison.smaller()).isGreaterThan(QUESTIONS / 30);
    }

    /** A failure that was found before the states were too many still counts. */
    @Test
    void saysTheSameAtTheLimit() {
        RandomRows rows = new RandomRows(AT_THE_LIMIT);
        compareWhole(rows, "Some");
        assertThat(comparison.packed(Answer.FAILS)).isEqualTo(1);
    }

    /** The very same, texts and numbers: the right side is in one configuration at a time. */
    private void compareWhole(RandomRows rows, String right) {
        comparison.compareWhole(rows.whole("Whole"), rows.whole(right), rows.toString());
    }
}
