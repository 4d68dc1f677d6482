package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Replay;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;

/**
 * Compositions whose parts calculate with Integers without an end, beside the same ones that get
 * few of them: those are tried one by one. What holds for all messages holds for few.
 */
class UnboundedPartsTest {
    private static final int QUESTIONS = Integer.getInteger("unbounded.parts", 40);

    /** What takes more work stays unknown, on a machine that is slow today as well as on any. */
    private static final long PATIENCE = 3_000;

    private int holds;
    private int fails;
    private int decided;

    @Tag("slow")
    @Test
    void decidesAboutAllMessagesAsAboutFew() {
        for (int seed = 0; seed < QUESTIONS; seed++) {
            ask(seed);
        }
        assertThat(decided).isGreaterThan(QUESTIONS / 2);
        assertThat(holds).isGreaterThan(QUESTIONS / 10);
        assertThat(fails).isGreaterThan(QUESTIONS / 10);
    }

    private void ask(int seed) {
        RandomParts question = new RandomParts(seed);
        Verdict all = verdict(question.models("Integer"));
        String about = "seed " + seed + ": " + String.join("\n", question.models("Integer"));
        if (all.answer() == Answer.UNKNOWN) {
            return;
        }
        decided++;
        if (all.answer() == Answer.FAILS) {
            fails++;
            return;
        }
        holds++;
        Verdict few = verdict(question.models("Integer[-3..5]"));
        assertThat(few.answer()).as(about).isNotEqualTo(Answer.FAILS);
    }

    private static Verdict verdict(List<String> texts) {
        Sides sides = Sides.of(texts);
        Verdict verdict = sides.check(new Budget(() -> false, 10_000).patient(PATIENCE));
        if (verdict.answer() == Answer.FAILS && !verdict.trace().isEmpty()) {
            Replay.check(sides.left(), sides.right(), verdict);
        }
        return verdict;
    }
}
