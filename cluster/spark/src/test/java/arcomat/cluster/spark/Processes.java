package arcomat.cluster.spark;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;

/** Processes of a test, whose output goes to files of a folder; they end with it. */
final class Processes implements AutoCloseable {
    private final Path folder;
    private final Map<String, String> environment;
    private final List<Process> started = new ArrayList<>();

    Processes(Path folder, Map<String, String> environment) {
        this.folder = folder;
        this.environment = environment;
    }

    /** Writes its results to the file {@code log}, and what else it says to {@code log.err}. */
    Process start(String log, List<String> command) throws IOException {
        ProcessBuilder builder =
                new ProcessBuilder(command)
                        .directory(folder.toFile())
                        .redirectOutput(folder.resolve(log).toFile())
                        .redirectError(folder.resolve(log + ".err").toFile());
        builder.environment().putAll(environment);
        Process process = builder.start();
        started.add(process);
        return process;
    }

    String output(String log) throws IOException {
        return Files.readString(folder.resolve(log));
    }

    /** A line of a file that may not be there yet. */
    String awaitLine(String log, Predicate<String> wanted) throws Exception {
        while (true) {
            Path file = folder.resolve(log);
            if (Files.exists(file)) {
                var found = Files.readAllLines(file).stream().filter(wanted).findFirst();
                if (found.isPresent()) {
                    return found.get();
                }
            }
            Thread.sleep(50);
        }
    }

    /** Programs of Spark start others, and end these only if they are asked to end themselves. */
    @Override
    public void close() {
        for (int i = started.size() - 1; i >= 0; i--) {
            ProcessHandle each = started.get(i).toHandle();
            List<ProcessHandle> below = each.descendants().toList();
            each.destroyForcibly();
            each.onExit().join();
            below.forEach(ProcessHandle::destroyForcibly);
            below.forEach(child -> child.onExit().join());
        }
    }
}
