package arcomat.benchmarks.measure;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Commands as processes of their own. */
public final class Command {
    private Command() {}

    /**
     * Runs one whose output nobody reads.
     *
     * @return the exit status, which is 0
     * @throws IllegalStateException if the command fails
     */
    public static int run(List<String> command) throws IOException, InterruptedException {
        int status =
                new ProcessBuilder(command)
                        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                        .redirectError(ProcessBuilder.Redirect.DISCARD)
                        .start()
                        .waitFor();
        if (status != 0) {
            throw new IllegalStateException(command + " ended with " + status);
        }
        return status;
    }

    /** Whether a program is installed: the command ends, and well. */
    public static boolean answers(String... command) {
        try {
            return run(List.of(command)) == 0;
        } catch (IOException | InterruptedException | IllegalStateException absent) {
            return false;
        }
    }

    /**
     * A program of ours in a process of its own, with as many classes as this one has, and compiled
     * as the start script wants it.
     *
     * @param memory the most that its heap may take, {@code 2g}
     */
    public static List<String> java(String memory, Class<?> program, List<String> arguments) {
        List<String> command =
                new ArrayList<>(
                        List.of(
                                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                                "-Xmx" + memory,
                                "-XX:+UseSerialGC",
                                "-XX:CompileThresholdScaling=3",
                                "-cp",
                                System.getProperty("java.class.path"),
                                program.getName()));
        command.addAll(arguments);
        return command;
    }
}
