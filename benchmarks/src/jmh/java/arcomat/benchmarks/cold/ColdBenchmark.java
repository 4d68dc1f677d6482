package arcomat.benchmarks.cold;

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
        Files.deleteIfExists(folder.resolve("Small.class"));
        Files.delete(folder.resolve("Small.java"));
        Files.delete(folder);
    }

    @Benchmark
    public int arcomat() throws IOException, InterruptedException {
        return run("build/install/arcomat/bin/arcomat", "check", "models/coffee");
    }

    @Benchmark
    public int javac() throws IOException, InterruptedException {
        String javac = Path.of(System.getProperty("java.home"), "bin", "javac").toString();
        return run(javac, "-d", folder.toString(), folder.resolve("Small.java").toString());
    }

    private static int run(String... command) throws IOException, InterruptedException {
        int status =
                new ProcessBuilder(command)
                        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                        .redirectError(ProcessBuilder.Redirect.DISCARD)
                        .start()
                        .waitFor();
        if (status != 0) {
            throw new IllegalStateException(command[0] + " ended with " + status);
        }
        return status;
    }
}
