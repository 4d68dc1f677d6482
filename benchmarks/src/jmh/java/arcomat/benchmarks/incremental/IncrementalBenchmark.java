package arcomat.benchmarks.incremental;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

import java.io.IOException;
import java.util.concurrent.TimeUnit;

/**
 * A thousand files, one of which has just changed, in a process that is warm, as in a build: from
 * the command line to the answer.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 4, time = 3)
@Measurement(iterations = 5, time = 2)
public class IncrementalBenchmark {
    private Project project;

    @Setup
    public void write() throws IOException, InterruptedException {
        project = new Project();
        project.check("--state", Project.STATE);
    }

    @TearDown
    public void remove() throws IOException {
        project.close();
    }

    @Benchmark
    public String full() throws IOException, InterruptedException {
        project.change(Project.PART);
        return project.check();
    }

    @Benchmark
    public String single() throws IOException, InterruptedException {
        project.change(Project.SINGLE);
        return project.check("--state", Project.STATE);
    }

    @Benchmark
    public String part() throws IOException, InterruptedException {
        project.change(Project.PART);
        return project.check("--state", Project.STATE);
    }
}
