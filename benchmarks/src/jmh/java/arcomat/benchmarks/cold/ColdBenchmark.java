package arcomat.benchmarks.cold;

import arcomat.benchmarks.measure.Command;
import arcomat.benchmarks.measure.Folders;

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
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** Whole processes, from the command to its exit. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 3)
@Measurement(iterations = 15)
public class ColdBenchmark {
    private Path folder;

    @Setup
    public void writeClass() throws IOException {
        folder = Files.createTempDirectory("cold");
        Files.writeString(
                folder.resolve("Small.java"),
                "public class Small {\n    int twice(int i) {\n        return 2 * i;\n    }\n}\n");
    }

    @TearDown
    public void remove() throws IOException {
        Folders.delete(folder);
    }

    @Benchmark
    public int arcomat() throws IOException, InterruptedException {
        return Command.run(List.of("build/install/arcomat/bin/arcomat", "check", "models/coffee"));
    }

    @Benchmark
    public int javac() throws IOException, InterruptedException {
        String javac = Path.of(System.getProperty("java.home"), "bin", "javac").toString();
        String small = folder.resolve("Small.java").toString();
        return Command.run(List.of(javac, "-d", folder.toString(), small));
    }
}
