package arcomat.analysis.contradiction;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.contradiction.Consistency.Contradiction;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Automaton;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;

/** A pair among many requirements is found without looking at all of them together. */
class CountersTest {
    private static final Budget BUDGET = new Budget(() -> false, 1_000_000);

    @Test
    void onePairOfTwelve() {
        Promise promise = Counters.of(12, 2, Map.of(4, 1, 9, 2));
        long[] asked = {0};
        Budget counting = new Budget(() -> ++asked[0] < 0, BUDGET.states());
        Consistency found = Contradictions.check(promise, false, counting);
        assertThat(names(found)).containsExactly(List.of("counter4", "counter9"));
        Contradiction contradiction = found.contradictions().get(0);
        assertThat(contradiction.minimal()).isTrue();
        assertThat(contradiction.word().orElseThrow()).hasSize(11);
        assertThat(asked[0]).as("steps on which the budget was asked").isLessThan(10_000);
    }

    @Test
    void allPairsOfTwelve() {
        Consistency found =
                Contradictions.check(
                        Counters.of(12, 2, Map.of(4, 1, 5, 1, 7, 2, 9, 2)), true, BUDGET);
        assertThat(names(found))
                .containsExactly(
                        List.of("counter4", "counter7"),
                        List.of("counter4", "counter9"),
                        List.of("counter5", "counter7"),
                        List.of("counter5", "counter9"));
    }

    @Test
    void oneTripleOfTwelve() {
        Promise promise = Counters.of(12, 3, Map.of(0, 1, 1, 2, 5, 3));
        Consistency found = Contradictions.check(promise, false, BUDGET);
        assertThat(names(found)).containsExactly(List.of("counter0", "counter1", "counter5"));
    }

    @Tag("slow")
    @Test
    void oneQuadrupleOfTwelve() {
        Promise promise = Counters.of(12, 4, Map.of(0, 1, 1, 2, 5, 3, 10, 4));
        Consistency found = Contradictions.check(promise, false, BUDGET);
        assertThat(names(found))
                .containsExactly(List.of("counter0", "counter1", "counter10", "counter5"));
    }

    @Test
    void noneOfTwelve() {
        Consistency found = Contradictions.check(Counters.of(12, 2, Map.of()), false, BUDGET);
        assertThat(found.answer()).isEqualTo(Answer.HOLDS);
        assertThat(found.controller()).isEmpty();
        assertThat(found.notes()).singleElement().asString().contains("too many");
    }

    private static List<List<String>> names(Consistency found) {
        return found.contradictions().stream()
                .map(each -> each.requirements().stream().map(Automaton::name).sorted().toList())
                .toList();
    }
}
