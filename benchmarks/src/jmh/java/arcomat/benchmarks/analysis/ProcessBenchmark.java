package arcomat.benchmarks.analysis;

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
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** The same questions to processes that have to start: the tool and MONA. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 1)
@Measurement(iterations = 5)
public class ProcessBenchmark {
    private static final String TOOL = "build/install/arcomat/bin/arcomat";
    private static final List<String> FIGURES =
            List.of("coffee.fig6.AvoidCrash", "coffee.fig5.AvoidCrash", "models/coffee");

    private Path folder;
    private List<String> small;

    @Setup
    public void write() throws IOException, InterruptedException {
        folder = Files.createTempDirectory("analysis");
        Path models = Files.createDirectories(folder.resolve("models").resolve("load"));
        Files.writeString(models.resolve("Types.cd"), Texts.types());
        String[] pair = Cases.random(20);
        Files.writeString(models.resolve("A.arc"), pair[0]);
        Files.writeString(models.resolve("B.arc"), pair[1]);
        small = List.of("load.A", "load.B", models.getParent().toString());
        ask("mona", FIGURES, "--out", folder.resolve("figure.mona").toString());
        ask("mona", small, "--out", folder.resolve("random.mona").toString());
    }

    @TearDown
    public void remove() throws IOException {
        Folders.delete(folder);
    }

    @Benchmark
    public int figureCold() throws IOException, InterruptedException {
        return ask("refines", FIGURES);
    }

    @Benchmark
    public int random20Cold() throws IOException, InterruptedException {
        return ask("refines", small);
    }

    @Benchmark
    public int figureMona() throws IOException, InterruptedException {
        return Command.run(List.of("mona", "-q", folder.resolve("figure.mona").toString()));
    }

    @Benchmark
    public int random20Mona() throws IOException, InterruptedException {
        return Command.run(List.of("mona", "-q", folder.resolve("random.mona").toString()));
    }

    private static int ask(String question, List<String> about, String... more)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(TOOL, question));
        command.addAll(List.of(more));
        command.addAll(about);
        return Command.run(command);
    }
}
