package arcomat.analysis.evolution;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Two versions of a component mean the same, however they are written, or they do not. */
class SameMeaningTest {
    private static final String COUNTER =
            """
            component Counter(Integer step = 1) {
              port in Boolean go, out Integer sum;
              <<completion = "ignore">> automaton {
                variable Integer[0..9] count = 0;
                state s, t;
                initial s / {sum = 0};
                s -> t [count < 5 && go] / {sum = count + step};
                t -> s {go == --} / {count = 2};
              }
            }
            """;

    private static Component component(String text) {
        Scenario scenario = Scenario.of("==== a/Counter.arc\npackage a;\n" + text);
        return Lowering.lower(scenario.workspace()).component("a.Counter").orElseThrow();
    }

    private static boolean same(String text) {
        return SameMeaning.own(component(COUNTER), component(text));
    }

    @Test
    void layoutAndCommentsMakeNoDifference() {
        assertThat(same("/** Counts. */\n\n" + COUNTER.replace("  ", " ").replace(";", " ;\n")))
                .isTrue();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '>',
            textBlock =
                    """
                    ignore          > output
                    0..9            > 0..8
                    count = 0       > count = 1
                    state s, t      > state t, s
                    s / {sum = 0}   > s
                    count < 5       > 5 < count
                    count + step    > count + 1
                    step = 1        > step = 2
                    {go == --}      > {go == ?}
                    {count = 2}     > {count = 2, sum = 1}
                    out Integer sum > out Integer sum, out Integer other
                    [count < 5 && go] > {go == true}
                    """)
    void whatTheModelSaysMakesOne(String old, String replacement) {
        String text = COUNTER.replace(old, replacement);
        assertThat(text).isNotEqualTo(COUNTER);
        assertThat(same(text)).isFalse();
    }
}
