package arcomat.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** The installed tool as processes of their own in a folder. */
final class ToolProcesses {
    private static final Path TOOL = Path.of("build/install/arcomat/bin/arcomat").toAbsolutePath();

    private final Path folder;
    private final List<Process> started = new ArrayList<>();

    ToolProcesses(Path folder) {
        this.folder = folder;
    }

    /**
     * Starts one.
     *
     * @param log file in the folder that takes what it prints
     */
    Process start(String log, List<String> arguments) throws IOException {
        return start(log, arguments, Map.of());
    }

    /** As above, with some variables of the environment. */
    Process start(String log, List<String> arguments, Map<String, String> environment)
            throws IOException {
        List<String> command = new ArrayList<>(List.of(TOOL.toString()));
        command.addAll(arguments);
        ProcessBuilder tool =
                new ProcessBuilder(command)
                        .directory(folder.toFile())
                        .redirectErrorStream(true)
                        .redirectOutput(folder.resolve(log).toFile());
        tool.environment().putAll(environment);
        Process process = tool.start();
        started.add(process);
        return process;
    }

    String log(String name) throws IOException {
        return Files.readString(folder.resolve(name));
    }

    /** How many rows a campaign has made so far. */
    long rows(String out) throws IOException {
        Path unfinished = folder.resolve(out).resolve("rows.unfinished");
        if (Files.notExists(unfinished)) {
            return 0;
        }
        try (Stream<String> lines = Files.lines(unfinished)) {
            return Math.max(0, lines.count() - 1);
        }
    }

    /** Lets processes stand still, or go on. */
    static void signal(String name, List<Process> processes) throws Exception {
        List<String> command = new ArrayList<>(List.of("kill", "-" + name));
        processes.forEach(each -> command.add(String.valueOf(each.pid())));
        if (new ProcessBuilder(command).start().waitFor() != 0) {
            throw new IOException("cannot send " + name);
        }
    }

    /** The time of processors that they have taken so far. */
    static Duration processorTime(List<Process> processes) {
        return processes.stream()
                .map(each -> each.info().totalCpuDuration().orElse(Duration.ZERO))
                .reduce(Duration.ZERO, Duration::plus);
    }

    /** Ends what is left. */
    void endAll() throws InterruptedException {
        for (Process each : started) {
            each.destroyForcibly().waitFor();
        }
    }
}
