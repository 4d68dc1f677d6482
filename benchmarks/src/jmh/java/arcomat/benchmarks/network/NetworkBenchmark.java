package arcomat.benchmarks.network;

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

import java.util.concurrent.TimeUnit;

/** A network of a thousand parts; one operation is {@link Messages#COUNT} slices. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(jvmArgsAppend = {"-Xmx2g", "-Xss64m"})
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 7, time = 500, timeUnit = TimeUnit.MILLISECONDS)
public class NetworkBenchmark {
    @Param({"1x1000", "100x10"})
    String shape;

    @Param({"generated", "shuffled", "objects", "arrays"})
    String contestant;

    private final int[] messages = Messages.draw();
    private Network network;

    @Setup
    public void build() {
        network = Networks.of(contestant, Shape.parse(shape));
    }

    @Benchmark
    public int network() {
        return network.run(messages);
    }
}
