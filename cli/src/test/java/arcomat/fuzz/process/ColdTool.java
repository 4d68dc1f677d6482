package arcomat.fuzz.process;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/** A process of its own for each call, by the start script. */
final class ColdTool implements Tool {
    private final Path streams;

    /**
     * @param streams a folder for what processes write to their streams
     */
    ColdTool(Path streams) throws IOException {
        this.streams = Files.createDirectories(streams);
    }

    @Override
    public Outcome run(Sandbox sandbox, Call call) throws IOException, InterruptedException {
        Path out = streams.resolve("out");
        Path err = streams.resolve("err");
        List<String> command = new ArrayList<>();
        command.add(Installation.command().toString());
        command.addAll(call.arguments());
        ProcessBuilder builder =
                new ProcessBuilder(command)
                        .directory(sandbox.folder().toFile())
                        .redirectInput(ProcessBuilder.Redirect.from(Path.of("/dev/null").toFile()))
                        .redirectOutput(out.toFile())
                        .redirectError(err.toFile());
        builder.environment().remove("COLUMNS");
        builder.environment().put("JAVA_OPTS", "-Djava.io.tmpdir=" + sandbox.temporary());
        Process process = builder.start();
        Duration busy = Duration.ZERO;
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
        while (!process.waitFor(50, TimeUnit.MILLISECONDS) && System.nanoTime() < end) {
            busy = process.info().totalCpuDuration().orElse(busy);
        }
        Optional<Integer> status =
                process.isAlive() ? Optional.empty() : Optional.of(process.exitValue());
        process.destroyForcibly().waitFor();
        return new Outcome(
                status, Files.readString(out), Files.readString(err), "", busy.toMillis() / 1e3);
    }

    @Override
    public void close() {}
}
