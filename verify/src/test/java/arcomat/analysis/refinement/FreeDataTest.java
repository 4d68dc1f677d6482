package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.NaiveInclusion;
import arcomat.analysis.RandomData;
import arcomat.analysis.RandomData.Few;
import arcomat.analysis.RandomData.Kind;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;

/**
 * Data that are only passed on and compared: the same verdicts, and counterexamples as short, as
 * with so few values that all of them can be tried.
 */
class FreeDataTest {
    private static final List<Kind> KINDS =
            List.of(RandomData.INTEGERS, RandomData.STRINGS, RandomData.LARGE_RANGE);

    private final Map<Answer, Integer> answers = new EnumMap<>(Answer.class);
    private int late;

    @Tag("slow")
    @Test
    void automataAnswerAsWithFewValues() {
        for (int seed = 0; seed < 200; seed++) {
            compare(seed, new RandomData(seed).atoms());
        }
        assertThat(answers.get(Answer.HOLDS)).isGreaterThan(50);
        assertThat(answers.get(Answer.FAILS)).isGreaterThan(65);
        assertThat(late).as("with data that have been stored").isGreaterThan(5);
        assertThat(answers.getOrDefault(Answer.UNKNOWN, 0)).isLessThan(10);
    }

    @Tag("slow")
    @Test
    void chainsAnswerAsWithFewValues() {
        for (int seed = 0; seed < 30; seed++) {
            compare(seed, new RandomData(seed).chains());
        }
        assertThat(answers.get(Answer.HOLDS)).isGreaterThan(7);
        assertThat(answers.get(Answer.FAILS)).isGreaterThan(3);
    }

    @Tag("slow")
    @Test
    void eventsAnswerAsWithFewValues() {
        for (int seed = 0; seed < 100; seed++) {
            compare(seed, new RandomData(seed, true).atoms());
        }
        assertThat(answers.get(Answer.HOLDS)).isGreaterThan(15);
        assertThat(answers.get(Answer.FAILS)).isGreaterThan(15);
    }

    @Tag("slow")
    @Test
    void chainsOfEventsAnswerAsWithFewValues() {
        for (int seed = 0; seed < 30; seed++) {
            compare(seed, new RandomData(seed, true).chains());
        }
        assertThat(answers.get(Answer.HOLDS)).isGreaterThan(3);
        assertThat(answers.get(Answer.FAILS)).isGreaterThan(3);
    }

    private void compare(int seed, List<String> texts) {
        Verdict few = verdict(RandomData.model(texts, new Few(9)));
        Kind kind = KINDS.get(seed % KINDS.size());
        Verdict many = verdict(RandomData.model(texts, kind));
        answers.merge(many.answer(), 1, Integer::sum);
        late += many.answer() == Answer.FAILS && many.trace().size() > 3 ? 1 : 0;
        if (few.answer() != Answer.UNKNOWN && many.answer() != Answer.UNKNOWN) {
            assertThat(many.answer()).as(text(seed, kind, texts)).isEqualTo(few.answer());
            assertThat(many.trace()).as(text(seed, kind, texts)).hasSameSizeAs(few.trace());
        }
    }

    private static String text(int seed, Kind kind, List<String> texts) {
        return "seed " + seed + ", " + kind + "\n" + String.join("\n", texts);
    }

    @Tag("slow")
    @Test
    void automataAnswerAsByTryingEveryLetter() {
        for (int seed = 1000; seed < 1030; seed++) {
            List<String> texts = new RandomData(seed).atoms();
            Model few = RandomData.model(texts, new Few(6));
            OptionalInt naive = new NaiveInclusion(left(few), right(few)).shortestFailure(3);
            Verdict many = verdict(RandomData.model(texts, RandomData.INTEGERS));
            if (many.reason().equals("delay")) {
                continue;
            }
            boolean fails = many.answer() == Answer.FAILS && many.trace().size() <= 4;
            assertThat(fails)
                    .as(text(seed, RandomData.INTEGERS, texts))
                    .isEqualTo(naive.isPresent());
            naive.ifPresent(length -> assertThat(many.trace()).hasSize(length + 1));
        }
    }

    private static Verdict verdict(Model model) {
        return Refinement.check(left(model), right(model), new Budget(() -> false, 4_000));
    }

    private static Promise left(Model model) {
        return Promise.of(model.component("r.Left").orElseThrow(), List.of());
    }

    private static Promise right(Model model) {
        return Promise.of(model.component("r.Right").orElseThrow(), List.of());
    }
}
