package arcomat.benchmarks;

import java.util.List;

/** Benchmarks that belong together. */
public interface Group {
    String name();

    /** The classes with the benchmarks. */
    List<Class<?>> benchmarks();

    /**
     * Runs before time is taken.
     *
     * @return what was found out, for the report
     * @throws IllegalStateException if contestants do not do the same
     */
    List<String> prepare();

    /** What the product promises, in the order of the report. */
    List<Goal> goals();
}
