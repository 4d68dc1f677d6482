package arcomat.benchmarks.build;

import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;
import arcomat.benchmarks.measure.Measurement;

import java.io.IOException;
import java.util.List;
import java.util.Map;

/** Builds of the coffee service with nothing to do, with the plugin and without it, in turn. */
public final class BuildGroup implements Group {
    @Override
    public String name() {
        return "build";
    }

    @Override
    public Map<String, Measurement> measure() throws IOException {
        return WarmBuilds.measure();
    }

    @Override
    public List<Goal> goals() {
        return List.of(
                Goal.difference(
                        "an up-to-date checkArc in a warm build, ms",
                        WarmBuilds.WITH,
                        WarmBuilds.WITHOUT,
                        50),
                Goal.difference(
                        "the same with the configuration cache, ms",
                        WarmBuilds.WITH + WarmBuilds.CACHED,
                        WarmBuilds.WITHOUT + WarmBuilds.CACHED,
                        50));
    }
}
