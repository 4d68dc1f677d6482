package arcomat.benchmarks.measure;

import java.io.IOException;
import java.util.List;
import java.util.Map;

/** Benchmarks that belong together. */
public interface Group {
    String name();

    /** The classes with the benchmarks; none for a group that takes the time itself. */
    default List<Class<?>> benchmarks() {
        return List.of();
    }

    /**
     * Runs before time is taken.
     *
     * @return what was found out, for the report
     * @throws IllegalStateException if contestants do not do the same
     */
    default List<String> prepare() {
        return List.of();
    }

    /** What a group without benchmark classes measured, by label. */
    default Map<String, Measurement> measure() throws IOException {
        throw new IllegalStateException("JMH measures this");
    }

    /** What the product promises, in the order of the report. */
    List<Goal> goals();
}
