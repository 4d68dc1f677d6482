package arcomat.benchmarks.guards;

import arcomat.model.Component;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import java.util.concurrent.TimeUnit;

/** Measures a guard that nests deeply, from the model to the code. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 4, time = 3)
@Measurement(iterations = 5, time = 2)
public class GuardBenchmark {
    @Param({"100", "200"})
    int depth;

    private Component component;

    @Setup
    public void read() {
        component = DeepGuard.component(depth);
    }

    @Benchmark
    public int guard() {
        return DeepGuard.generate(component, "lejos");
    }
}
