package arcomat.benchmarks.incremental;

import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;

/** Checks that remember the last one. */
public final class IncrementalGroup implements Group {
    @Override
    public String name() {
        return "incremental";
    }

    @Override
    public List<Class<?>> benchmarks() {
        return List.of(IncrementalBenchmark.class);
    }

    @Override
    public List<String> prepare() {
        try (Project project = new Project()) {
            project.check("--state", Project.STATE, "--verbose");
            project.change(Project.SINGLE);
            String single = project.check("--state", Project.STATE, "--verbose");
            project.change(Project.PART);
            String part = project.check("--state", Project.STATE, "--verbose");
            return List.of("single: " + single, "part: " + part);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
    }

    @Override
    public List<Goal> goals() {
        return List.of(
                Goal.promise(
                        "after a change of a model that nobody uses, against all",
                        "single",
                        "full",
                        0.1),
                Goal.promise(
                        "after a change of a model that is a part of another, against all",
                        "part",
                        "full",
                        0.1));
    }
}
