package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Sections;
import arcomat.analysis.Verdicts;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Model;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.util.List;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * The left side has no end, the counterexample is short: it is found with few states and with many,
 * and with little work. Below {@code == endless A B} stands the trace.
 */
class EndlessTest {
    private static final long PATIENCE = 3_000_000;

    @TestFactory
    Stream<DynamicTest> shortFailuresAreFoundSoon() {
        Sections sections = Sections.read(VerdictsTest.FOLDER.resolve("endless.txt"));
        Model model = sections.model();
        return sections.of("endless").stream()
                .flatMap(
                        ask ->
                                LongStream.of(1_000, 100_000_000)
                                        .mapToObj(
                                                states ->
                                                        DynamicTest.dynamicTest(
                                                                ask.rest() + " " + states,
                                                                () -> check(model, ask, states))));
    }

    private static void check(Model model, Sections.Section ask, long states) {
        List<Promise> sides =
                Stream.of(ask.rest().split(" "))
                        .map(name -> model.component(name).orElseThrow())
                        .map(component -> Promise.of(component, List.of()))
                        .toList();
        Budget budget = new Budget(() -> false, states).patient(PATIENCE);
        Verdict verdict = Refinement.check(sides.get(0), sides.get(1), budget);
        assertThat(verdict.answer()).as(verdict.reason()).isEqualTo(Answer.FAILS);
        assertThat(Verdicts.trace(verdict.trace())).isEqualTo(ask.lines().get(0));
    }
}
