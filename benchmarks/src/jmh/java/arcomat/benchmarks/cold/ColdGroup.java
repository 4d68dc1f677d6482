package arcomat.benchmarks.cold;

import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;

import java.util.List;

/** The first answer of the day: a process that has to start. */
public final class ColdGroup implements Group {
    @Override
    public String name() {
        return "cold";
    }

    @Override
    public List<Class<?>> benchmarks() {
        return List.of(ColdBenchmark.class);
    }

    @Override
    public List<Goal> goals() {
        return List.of(
                Goal.promise(
                        "arcomat check models/coffee, against javac on one small class",
                        "arcomat",
                        "javac",
                        1));
    }
}
