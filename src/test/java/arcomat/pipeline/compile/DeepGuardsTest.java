package arcomat.pipeline.compile;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.model.Component;
import arcomat.models.ReadModels;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;

/** Code for guards that nest grows as they do, and does what the interpreter does. */
@Tag("slow")
class DeepGuardsTest {
    private static final int DEPTH = 100;

    /** So many letters at most stand for one more level, whatever the shape. */
    private static final int LETTERS_PER_LEVEL = 120;

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            textBlock =
                    """
                    a; n == # ? a : (@)
                    b; !(n == # ? a : @)
                    b; a && n > # || (b && (@))
                    n > 0; a && (b || (@))
                    a; n > # ? (@) : b
                    b; a implies (@)
                    b; (@) implies a
                    b; !(b || !(a && (@)))
                    b; a == (@)
                    """)
    void codeGrowsWithTheGuard(String innermost, String around) {
        int half = size(component(innermost, around, DEPTH / 2));
        Component whole = component(innermost, around, DEPTH);
        assertThat(size(whole) - half).isLessThan(DEPTH / 2 * LETTERS_PER_LEVEL);
        new Agreement(whole, List.of()).holds(1, 20);
    }

    /** What nests inside of conditions and comparisons costs the square, and does not double. */
    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            textBlock =
                    """
                    n > 0; (@) ? a : b
                    b; a == (b && (@))
                    b; (a == (@)) ? a : b
                    b; ((@) || a) != b
                    """)
    void codeOfConditionsInConditionsDoesNotDouble(String innermost, String around) {
        Component whole = component(innermost, around, 24);
        assertThat(size(whole)).isLessThan(24 * 24 * LETTERS_PER_LEVEL);
        new Agreement(whole, List.of()).holds(1, 20);
    }

    /**
     * @param around the next level, with {@code @} for what stands inside and {@code #} for its
     *     number
     */
    private static Component component(String innermost, String around, int depth) {
        String guard = innermost;
        for (int i = 0; i < depth; i++) {
            guard = around.replace("#", String.valueOf(i)).replace("@", guard);
        }
        String text =
                """
                component Deep {
                    timing instant;
                    port in Boolean a, in Boolean b, in Integer n, out Boolean o;
                    <<completion = "ignore">> automaton {
                        state s;
                        initial s;
                        s [%s] / {o = true};
                    }
                }
                """
                        .formatted(guard);
        return ReadModels.model(new SourceFile("Deep.arc", text)).component("Deep").orElseThrow();
    }

    private static int size(Component component) {
        Target target = Target.shipped("jvm").orElseThrow();
        return Generator.generate(Request.library(component, Choosing.FIRST), target)
                .files()
                .stream()
                .mapToInt(file -> file.text().length())
                .sum();
    }
}
