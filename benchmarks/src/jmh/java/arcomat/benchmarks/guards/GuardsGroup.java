package arcomat.benchmarks.guards;

import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;

import java.util.List;

/** Code for guards that nest. */
public final class GuardsGroup implements Group {
    @Override
    public String name() {
        return "guards";
    }

    @Override
    public List<Class<?>> benchmarks() {
        return List.of(GuardBenchmark.class);
    }

    @Override
    public List<String> prepare() {
        int half = DeepGuard.generate(DeepGuard.component(100), "lejos");
        int whole = DeepGuard.generate(DeepGuard.component(200), "lejos");
        return List.of("code: %,d letters for 100 levels, %,d for 200".formatted(half, whole));
    }

    @Override
    public List<Goal> goals() {
        return List.of(
                Goal.promise("a guard of 200 levels, against 100", "guard 200", "guard 100", 2.2),
                Goal.limit("a guard of 200 levels, in ms", "guard 200", 2000));
    }
}
