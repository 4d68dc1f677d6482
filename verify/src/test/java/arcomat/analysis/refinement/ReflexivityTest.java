package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomData;
import arcomat.analysis.Sections;
import arcomat.analysis.refinement.Difference.Relation;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.util.List;
import java.util.stream.Stream;

/** Every component refines itself, even where a search does not find out. */
class ReflexivityTest {
    private static final Budget BUDGET = searching(100_000_000);
    private static final Budget LITTLE = searching(1_000);

    /** For a search alone: conditions over variables would show the same. */
    private static Budget searching(long pairs) {
        return new Budget(() -> false, pairs).with(rule -> rule != Shortcut.CONDITIONS);
    }

    /** Below {@code == same A} a part of a note. */
    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> holdsWhereTheSearchIsGivenUp() {
        Sections sections = Sections.read(VerdictsTest.FOLDER.resolve("data.txt"));
        Model model = sections.model();
        return sections.of("same").stream()
                .map(
                        same ->
                                DynamicTest.dynamicTest(
                                        same.rest(),
                                        () -> check(promise(model, same.rest()), same.lines())));
    }

    private static void check(Promise same, List<String> lines) {
        Verdict search = Certification.of(same, same, LITTLE).verdict();
        assertThat(search.answer()).isEqualTo(Answer.UNKNOWN);
        Verdict verdict = Refinement.check(same, same, BUDGET);
        assertThat(verdict.answer()).isEqualTo(Answer.HOLDS);
        assertThat(String.join("\n", verdict.notes())).contains(lines);
        assertThat(Difference.of(same, same, BUDGET).relation()).isEqualTo(Relation.EQUIVALENT);
    }

    @Tag("slow")
    @Test
    void aSearchNeverSaysOtherwise() {
        for (int seed = 0; seed < 300; seed++) {
            Model model = RandomData.model(new RandomData(seed).chains(), RandomData.INTEGERS);
            for (String name : List.of("r.Left", "r.First")) {
                Promise same = promise(model, name);
                assertThat(Certification.of(same, same, LITTLE).verdict().answer())
                        .isNotEqualTo(Answer.FAILS);
            }
        }
    }

    @Test
    void otherSidesAreSearched() {
        Model model = Sections.read(VerdictsTest.FOLDER.resolve("data.txt")).model();
        assertThat(check(model, "d.Slower", "d.Slow").answer()).isEqualTo(Answer.FAILS);
        assertThat(check(model, "d.OpenThenRelay", "d.TwoRelays").answer())
                .isEqualTo(Answer.UNKNOWN);
    }

    private static Verdict check(Model model, String left, String right) {
        return Refinement.check(promise(model, left), promise(model, right), BUDGET);
    }

    private static Promise promise(Model model, String name) {
        return Promise.of(model.component(name).orElseThrow(), List.of());
    }
}
