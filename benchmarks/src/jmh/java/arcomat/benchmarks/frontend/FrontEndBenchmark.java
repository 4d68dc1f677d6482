package arcomat.benchmarks.frontend;

import arcomat.source.SourceFile;

import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import java.util.List;
import java.util.concurrent.TimeUnit;

/** A thousand components against as much Java, warm. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(jvmArgsAppend = {FrontEnd.HEAP, FrontEnd.HEAP_LIMIT, FrontEnd.PAUSES, FrontEnd.TENURING})
@Warmup(iterations = 4, time = 3)
@Measurement(iterations = 5, time = 2)
public class FrontEndBenchmark {
    static final int COUNT = 1000;

    private List<SourceFile> models;
    private List<SourceFile> classes;

    @Setup
    public void write() {
        models = Texts.models(COUNT);
        classes = Texts.classes(Texts.length(models));
    }

    @Benchmark
    public int arcomatParse() {
        return FrontEnd.parse(models).size();
    }

    @Benchmark
    public int arcomatCheck() {
        return FrontEnd.check(models).size();
    }

    @Benchmark
    public int javacParse() {
        return InMemoryJavac.parse(classes);
    }

    @Benchmark
    public boolean javacFull() {
        return InMemoryJavac.compile(classes);
    }
}
