package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Replay;
import arcomat.analysis.automaton.InstalledZ3;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;

import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.LongFunction;

/**
 * Questions about Integers, Doubles and Strings without an end, beside Z3, which is told of vectors
 * of bits and of floating point: nothing may be decided otherwise, and little may stay open.
 */
class UnboundedDataTest {
    private static final int QUESTIONS = Integer.getInteger("unbounded.questions", 20);

    private final List<String> open = new ArrayList<>();
    private int holds;
    private int fails;
    private int compared;

    @Tag("slow")
    @Test
    void decidesAsZ3Does() {
        compare(QUESTIONS, RandomQuestion::new, RandomQuestion::models);
        assertThat(open).hasSizeLessThanOrEqualTo(QUESTIONS / 20);
        assertThat(compared).isGreaterThan(QUESTIONS * 3 / 4);
    }

    @Tag("slow")
    @Test
    void decidesCompositionsAsZ3Does() {
        compare(QUESTIONS, RandomQuestion::new, RandomQuestion::composed);
        assertThat(open).hasSizeLessThanOrEqualTo(QUESTIONS / 20);
        assertThat(compared).isGreaterThan(QUESTIONS * 3 / 4);
    }

    /** Z3 gives up on some of these, and takes its time for others. */
    @Tag("slow")
    @Test
    void decidesRealsAsZ3Does() {
        int few = QUESTIONS / 6;
        compare(few, seed -> new RandomQuestion(seed, true), RandomQuestion::models);
        assertThat(open).hasSizeLessThanOrEqualTo(few / 10);
        assertThat(compared).isGreaterThan(few / 2);
    }

    private void compare(
            int count,
            LongFunction<RandomQuestion> questions,
            Function<RandomQuestion, List<String>> models) {
        Assumptions.assumeTrue(InstalledZ3.isThere(), "no program 'z3'");
        for (int seed = 0; seed < count; seed++) {
            ask(seed, questions.apply(seed), models);
        }
        assertThat(holds).isGreaterThan(count / 4);
        assertThat(fails).isGreaterThan(count / 10);
    }

    private void ask(
            int seed, RandomQuestion question, Function<RandomQuestion, List<String>> models) {
        List<String> texts = models.apply(question);
        Sides sides = Sides.of(texts);
        Verdict verdict = sides.check(new Budget(() -> false, 10_000));
        String about = "seed " + seed + ": " + String.join("\n", texts);
        if (verdict.answer() == Answer.UNKNOWN) {
            open.add(seed + ": " + verdict.reason());
            return;
        }
        boolean yes = verdict.answer() == Answer.HOLDS;
        holds += yes ? 1 : 0;
        fails += yes ? 0 : 1;
        if (!yes) {
            Replay.check(sides.left(), sides.right(), verdict);
        }
        Boolean truth = question.holds(InstalledZ3::answers);
        if (truth != null) {
            compared++;
            assertThat(yes).as(about).isEqualTo(truth);
        }
    }
}
