package arcomat.analysis.search.system;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.symbols.Scenario;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which automata may end a run with an error, as far as their text tells. */
class RunErrorsTest {
    private static boolean possible(String completion, String transition) {
        String text =
                """
                ==== a/T.cd
                package a;
                classdiagram T { class Thing { Integer[0..9] size; } }
                ==== a/C.arc
                package a;
                import a.T.Thing;
                component C(Integer[0..9] k = 1) {
                  port in Integer[0..9] x, in Thing t, in Integer w, out Integer[0..9] y, out Integer any;
                  <<completion = "%s">> automaton {
                    variable Integer[0..9] n = 0;
                    variable Integer[0..5] few = 0;
                    variable Integer total = 0;
                    variable Double real = 0.0;
                    state s;
                    initial s;
                    s %s;
                  }
                }
                """
                        .formatted(completion, transition);
        Component component =
                Lowering.lower(Scenario.of(text).workspace()).component("a.C").orElseThrow();
        return RunErrors.arePossible(component.automata().get(0));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    {x == ?}                 | false
                    {x == ?} / {y = 3}       | false
                    {x == ?} / {y = x}       | false
                    {x == ?} / {y = n}       | false
                    {x == ?} / {n = x}       | false
                    {x == ?} / {n = 9}       | false
                    {x == ?} / {y = --}      | false
                    [x + 1 > n] / {y = x}    | false
                    {x == ?} / {y = x + 1}   | true
                    {x == ?} / {y = x - 1}   | true
                    {x == ?} / {y = few + 4} | false
                    {x == ?} / {y = few + 5} | true
                    {w == ?} / {any = w + 1} | false
                    {w == ?} / {total = w * w} | false
                    {w == ?} / {total = w / (n + 1)} | false
                    {w == ?} / {total = w / (n - 9)} | true
                    {w == ?} / {y = w % 10}  | true
                    {x == ?} / {y = x % 10}  | false
                    {x == ?} / {y = w > 0 ? x : n} | false
                    {x == ?} / {y = w > 0 ? w : n} | true
                    {w == ?} / {real = w / 2.0 / n} | false
                    {w == ?} / {y = (Integer) (real / n)} | true
                    {x == ?} / {n = n + 1}   | true
                    {w == ?} / {y = w}       | true
                    {x == ?} / {few = x}     | true
                    {x == ?} / {few = few}   | false
                    [6 / n == 1]             | true
                    [w % n == 1] / {y = x}   | true
                    {x = alt {1, 6 / n}}     | true
                    {x == ?} / {y = k}       | true
                    {x == ?} / {y = t.size}  | true
                    {x == ?} / {total = w / (k + 1)} | true
                    {x = alt {1, n}}         | false
                    {x = alt {1, 6 / (n + 1)}} | false
                    """)
    void whatIsCalculatedMayGoWrong(String transition, boolean possible) {
        assertThat(possible("ignore", transition)).isEqualTo(possible);
        assertThat(possible("output", transition)).isEqualTo(possible);
        assertThat(possible("error", transition)).isTrue();
    }
}
