package arcomat.analysis.automaton;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** The solver Z3 of the machine that the tests run on, if it has one. */
public final class InstalledZ3 {
    /** In units of its own; three to ten million of them take a second. */
    private static final String MOST_WORK = "5000000";

    private InstalledZ3() {}

    public static boolean isThere() {
        try {
            Process process = new ProcessBuilder("z3", "--version").start();
            return process.waitFor(10, TimeUnit.SECONDS) && process.exitValue() == 0;
        } catch (IOException absent) {
            return false;
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    /**
     * What it prints, line by line: {@code sat}, {@code unsat} or {@code unknown}, where it has
     * worked too long. Work is counted, not time: a busy machine has the same answers.
     */
    public static List<String> answers(List<String> script) {
        try {
            Process process =
                    new ProcessBuilder("z3", "-in", "rlimit=" + MOST_WORK)
                            .redirectErrorStream(true)
                            .start();
            process.getOutputStream()
                    .write(String.join("\n", script).getBytes(StandardCharsets.UTF_8));
            process.getOutputStream().close();
            byte[] printed = process.getInputStream().readAllBytes();
            process.waitFor();
            // Giving up is also told as an error.
            return new String(printed, StandardCharsets.UTF_8)
                    .lines()
                    .filter(line -> !line.endsWith("canceled\")"))
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }
}
