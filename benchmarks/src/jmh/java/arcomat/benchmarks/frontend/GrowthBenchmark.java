package arcomat.benchmarks.frontend;

import arcomat.source.SourceFile;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import java.util.List;
import java.util.concurrent.TimeUnit;

/** Whether the cost of a model depends on how many there are. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(jvmArgsAppend = {FrontEnd.HEAP, FrontEnd.HEAP_LIMIT, FrontEnd.PAUSES, FrontEnd.TENURING})
@Warmup(iterations = 4, time = 3)
@Measurement(iterations = 5, time = 2)
public class GrowthBenchmark {
    @Param({"100", "1000", "10000"})
    int count;

    private List<SourceFile> models;

    @Setup
    public void write() {
        models = Texts.models(count);
    }

    @Benchmark
    public int growth() {
        return FrontEnd.check(models).size();
    }
}
