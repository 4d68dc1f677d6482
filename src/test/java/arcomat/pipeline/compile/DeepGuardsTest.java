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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;

/** Code for guards that nest grows as they do, and does what the interpreter does. */
class DeepGuardsTest {
    private static final int DEPTH = 200;

    /** What twice as deep a guard costs, and a little more. */
    private static final double DOUBLED = 2.2;

    /**
     * What stands innermost, and what stands around it in each level: {@code @} is what stands
     * inside, and {@code #} the number of the level.
     */
    private static final String SHAPES =
            """
            a; n == # ? a : (@)
            b; !(@) != a
            b; a && n > # || (b && (@))
            n > 0; a && (b || (@))
            a; n > # ? (@) : b
            b; a implies (@)
            b; (@) implies a
            b; !(b || !(a && @))
            b; a == (@)
            n > 0; (@) ? a : b
            b; a == (b && (@))
            b; a == ((@) && b)
            b; (a == (@)) ? a : b
            b; ((@) || a) != b
            b; a != (b || !(@))
            b; (a implies (@)) == b
            b; ((@) implies a) != b
            b; a ? (@) == b : b
            b; (a && (@)) ? b : (a || b)
            n > 0; n == ((@) ? 1 : 2)
            n > 0; ((@) ? 6 / n : n) + 1 > n
            b; n > ((@) ? 1 : 2) == (a || 6 / n > 1)
            n > 0; (a && 6 / n > 1) == (@)
            n > 0; (@) == (a && 6 / n > 1)
            n > 0; a == ((@) && 6 / n > 1)
            n > 0; a == (6 / n > 1 && (@))
            n > 0; a != ((@) || 6 / n > #)
            n > 0; a != (6 / n > # || !(@))
            n > 0; (6 / n > 1 implies @) == b
            n > 0; ((@) implies 6 / n > 1) == b
            n > 0; (@) ? 6 / n > 1 : b
            n > 0; ((@) && 6 / n > #) ? a : 12 / n > #
            n > 0; (6 / n > # || !(@)) ? a != b : b
            n > 0; (a == -- && (@)) == (6 / n > 1 || b)
            """;

    @ParameterizedTest
    @CsvSource(delimiter = ';', textBlock = SHAPES)
    void codeGrowsWithTheGuard(String innermost, String around) {
        growsWith(
                nested(innermost, List.of(around), DEPTH / 2),
                nested(innermost, List.of(around), DEPTH));
    }

    @Test
    void codeGrowsWithAGuardOfManyShapes() {
        List<String> shapes = shapes();
        int levels = 2 * shapes.size();
        growsWith(nested("a", shapes, levels), nested("a", shapes, 2 * levels));
    }

    private static void growsWith(String half, String whole) {
        for (String target : List.of("jvm", "lejos")) {
            assertThat(size(component(whole), target))
                    .as(target)
                    .isLessThan((int) (size(component(half), target) * DOUBLED));
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @CsvSource(delimiter = ';', textBlock = SHAPES)
    void codeDoesWhatTheInterpreterDoes(String innermost, String around) {
        agrees(nested(innermost, List.of(around), DEPTH));
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
    void codeOfManyShapesDoesWhatTheInterpreterDoes(int seed) {
        List<String> shapes = shapes();
        Collections.shuffle(shapes, new Random(seed));
        agrees(nested("b", shapes.subList(0, 4 + seed), 5 * seed));
    }

    private static void agrees(String guard) {
        new Agreement(component(guard), List.of()).holds(30, 20);
    }

    /** What stands around a guard, in each line. */
    private static List<String> shapes() {
        return SHAPES.lines().map(line -> line.split("; ", 2)[1]).collect(Collectors.toList());
    }

    private static String nested(String innermost, List<String> around, int depth) {
        String guard = innermost;
        for (int i = 0; i < depth; i++) {
            String next = around.get(i % around.size());
            guard = next.replace("#", String.valueOf(i)).replace("@", guard);
        }
        return guard;
    }

    private static Component component(String guard) {
        String text =
                """
                component Deep {
                    timing instant;
                    port in Boolean a, in Boolean b, in Integer[0..9] n, out Boolean o;
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

    private static int size(Component component, String name) {
        Target target = Target.shipped(name).orElseThrow();
        return Generator.generate(Request.library(component, Choosing.FIRST), target)
                .files()
                .stream()
                .mapToInt(file -> file.text().length())
                .sum();
    }
}
