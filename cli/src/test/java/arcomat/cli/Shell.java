package arcomat.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Runs the installed command in lines of a shell, where {@code $A} is the command and {@code $M}
 * the coffee robots.
 *
 * @param folder that the shell starts in
 */
record Shell(Path folder) {
    private static final String COMMAND =
            Path.of("build/install/arcomat/bin/arcomat").toAbsolutePath().toString();
    private static final String MODELS = Path.of("models/coffee").toAbsolutePath().toString();

    /**
     * @param out what it wrote to standard output
     * @param err what it wrote to standard error
     */
    record Outcome(int status, String out, String err) {}

    Outcome run(String line) throws Exception {
        return run(line, Map.of());
    }

    /**
     * @param environment in addition to that of the test
     */
    Outcome run(String line, Map<String, String> environment) throws Exception {
        Path out = Files.createTempFile("arcomat", "out");
        Path err = Files.createTempFile("arcomat", "err");
        ProcessBuilder shell =
                new ProcessBuilder(List.of("bash", "-c", line))
                        .directory(folder.toFile())
                        .redirectOutput(out.toFile())
                        .redirectError(err.toFile());
        shell.environment().putAll(Map.of("A", COMMAND, "M", MODELS));
        shell.environment().putAll(environment);
        int status = shell.start().waitFor();
        return new Outcome(status, read(out), read(err));
    }

    private static String read(Path file) throws IOException {
        String text = Files.readString(file, StandardCharsets.UTF_8);
        Files.delete(file);
        return text;
    }
}
