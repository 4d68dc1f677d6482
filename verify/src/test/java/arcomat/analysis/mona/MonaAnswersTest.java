package arcomat.analysis.mona;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Replay;
import arcomat.analysis.Sections;
import arcomat.analysis.Verdicts;
import arcomat.analysis.refinement.MonaRefinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.VerdictsTest;
import arcomat.analysis.search.Budget;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * What counterexamples of MONA mean, without the program: {@code == answer MODELS LEFT RIGHT
 * COMPLETIONS} is about a question of {@link VerdictsTest}, first with the lines that MONA has
 * written, each a bit with its values, then with what is told. Below {@code == refused LEFT RIGHT}
 * stands why MONA is not asked.
 */
class MonaAnswersTest {
    private static final Sections DATA =
            Sections.read(Path.of("verify/src/test/resources/analysis/mona.txt"));

    @TestFactory
    Stream<DynamicTest> answers() {
        return DATA.of("answer").stream()
                .map(each -> DynamicTest.dynamicTest(each.rest(), () -> check(each)));
    }

    private static void check(Sections.Section section) {
        String[] words = section.rest().split(" ");
        Model model = Sections.read(VerdictsTest.FOLDER.resolve(words[0])).model();
        Promise left = VerdictsTest.promise(model, words[1], words[3].charAt(0));
        Promise right =
                VerdictsTest.promise(model, words[2], words[3].charAt(words[3].length() - 1));
        List<String> bits = section.lines().stream().filter(MonaAnswersTest::isBit).toList();
        Map<String, String> rows = new HashMap<>();
        bits.forEach(line -> rows.put(line.split(" ")[0], line.split(" ")[1]));
        Verdict verdict = MonaRefinement.of(left, right, Budget.ofMemory()).fails(rows);
        assertThat(told(verdict))
                .isEqualTo(section.lines().subList(bits.size(), section.lines().size()));
        if (!verdict.trace().isEmpty()) {
            Replay.check(left, right, verdict);
        }
    }

    private static boolean isBit(String line) {
        return line.matches("\\S+ [01X]+");
    }

    private static List<String> told(Verdict verdict) {
        if (verdict.answer() == Verdict.Answer.UNKNOWN) {
            return List.of("unknown " + verdict.reason());
        }
        List<String> lines = new ArrayList<>();
        lines.add(Verdicts.text(verdict, "fails {"));
        verdict.explanation().forEach(sentence -> lines.add("  " + sentence.text()));
        return lines;
    }

    @TestFactory
    Stream<DynamicTest> refusals() {
        Model model = DATA.model();
        return DATA.of("refused").stream()
                .map(
                        each ->
                                DynamicTest.dynamicTest(
                                        each.rest(),
                                        () ->
                                                assertThat(refusal(model, each.rest()))
                                                        .isEqualTo(
                                                                String.join("\n", each.lines()))));
    }

    private static String refusal(Model model, String names) {
        return of(model, names, Budget.ofMemory()).settled().orElseThrow().reason();
    }

    private static MonaRefinement of(Model model, String names, Budget budget) {
        return MonaRefinement.of(
                VerdictsTest.promise(model, names.split(" ")[0], '-'),
                VerdictsTest.promise(model, names.split(" ")[1], '-'),
                budget);
    }

    @Test
    void statesAreSpelledOutAsFarAsTheBudgetGoes() {
        Model model = DATA.model();
        assertThat(of(model, "m.Ten m.Ten", Budget.ofMemory().atMost(9)).question()).isPresent();
        Verdict verdict =
                of(model, "m.Ten m.Ten", Budget.ofMemory().atMost(8)).settled().orElseThrow();
        assertThat(verdict.answer()).isEqualTo(Verdict.Answer.UNKNOWN);
        assertThat(verdict.reason()).isEqualTo("m.Ten: more than 8 states");
    }
}
