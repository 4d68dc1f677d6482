package arcomat.benchmarks.guards;

import arcomat.benchmarks.measure.LoweredSources;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.model.Component;

import java.util.List;

/** Connectives that may err, compared in each other and as conditions, so many levels deep. */
final class DeepGuard {
    private static final List<String> LEVELS =
            List.of("a == ((@) && 6 / n > 1)", "(b || (@)) ? a : 6 / n > 1");

    private DeepGuard() {}

    static Component component(int depth) {
        String guard = "b";
        for (int level = 0; level < depth; level++) {
            guard = LEVELS.get(level % LEVELS.size()).replace("@", guard);
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
        return LoweredSources.of("deep", List.of(text)).component("Deep").orElseThrow();
    }

    /** How many letters the code has. */
    static int generate(Component component, String target) {
        return Generator.generate(
                        Request.library(component, Choosing.FIRST),
                        Target.shipped(target).orElseThrow())
                .files()
                .stream()
                .mapToInt(file -> file.text().length())
                .sum();
    }
}
