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

/** Chains of growing length; one operation is {@link Messages#COUNT} slices. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(jvmArgsAppend = {"-Xmx4g", "-Xss64m"})
@Warmup(iterations = 6, time = 2)
@Measurement(iterations = 5, time = 1)
public class NetworkGrowthBenchmark {
    @Param({"1x10", "1x100", "1x1000", "1x10000", "1x100000"})
    String shape;

    @Param({"generated", "objects"})
    String contestant;

    private final int[] messages = Messages.draw();
    private Network network;

    @Setup
    public void build() {
        network = Networks.of(contestant, Shape.parse(shape));
    }

    @Benchmark
    public int growth() {
        return network.run(messages);
    }
}
