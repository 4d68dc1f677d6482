package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomNetworks;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;

import org.junit.jupiter.api.Test;

import java.util.EnumMap;
import java.util.Map;

/**
 * Packed configurations give the very same verdicts as those that are not: texts and numbers. What
 * only packed searches leave out besides is in {@link LeftOutTest}.
 */
class PackedInclusionTest {
    private static final int QUESTIONS = Integer.getInteger("packed.questions", 300);
    private static final int SEED = Integer.getInteger("packed.seed", 19);

    /** Of rows that fail on the level on which they have more states than that. */
    private static final int AT_THE_LIMIT = 403;

    private static final Budget BUDGET = new Budget(() -> false, 3_000);

    private final Map<Answer, Integer> packed = new EnumMap<>(Answer.class);

    @Test
    void saysTheSameOfNetworks() {
        RandomNetworks networks = new RandomNetworks(SEED);
        for (int i = 0; i < QUESTIONS; i++) {
            RandomNetworks.Question question = networks.question();
            compare(question.left(), question.right(), question.text());
        }
        assertThat(packed.get(Answer.HOLDS)).isGreaterThan(QUESTIONS / 30);
        assertThat(packed.get(Answer.FAILS)).isGreaterThan(QUESTIONS / 30);
    }

    /** Parts of one kind share the widths of their fields: those once did not fit the tables. */
    @Test
    void saysTheSameOfRows() {
        for (int i = 0; i < QUESTIONS / 4; i++) {
            RandomRows rows = new RandomRows(SEED + i);
            compare(rows.whole("Whole"), rows.whole("Any"), rows.toString());
            compare(rows.whole("Whole"), rows.whole("Some"), rows.toString());
        }
        assertThat(packed.get(Answer.HOLDS)).isGreaterThan(QUESTIONS / 30);
        assertThat(packed.get(Answer.FAILS)).isGreaterThan(QUESTIONS / 30);
    }

    /** A failure that was found before the states were too many still counts. */
    @Test
    void saysTheSameAtTheLimit() {
        RandomRows rows = new RandomRows(AT_THE_LIMIT);
        compare(rows.whole("Whole"), rows.whole("Some"), rows.toString());
        assertThat(packed).containsEntry(Answer.FAILS, 1);
    }

    private void compare(Promise left, Promise right, String text) {
        boolean[] taken = {false};
        Verdict quick = Refinement.compare(left, right, BUDGET.with(rule -> noted(rule, taken)));
        Verdict thorough =
                Refinement.compare(left, right, BUDGET.with(rule -> rule != Shortcut.PACKED));
        assertThat(quick).as(text).isEqualTo(thorough);
        if (taken[0]) {
            packed.merge(quick.answer(), 1, Integer::sum);
        }
    }

    private static boolean noted(Shortcut rule, boolean[] taken) {
        taken[0] |= rule == Shortcut.PACKED;
        return !LeftOutTest.RULES.contains(rule);
    }
}
