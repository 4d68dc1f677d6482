package arcomat.gradle;

import org.gradle.api.GradleException;
import org.gradle.api.logging.Logger;
import org.gradle.api.tasks.VerificationException;

import java.util.List;

/**
 * What came of a command.
 *
 * @param status its exit status
 * @param out what it found, as text for people
 * @param err its complaints about how it was used, and how it went about its work
 */
record ToolResult(int status, String out, String err) {
    private static final int FINE = 0;
    private static final int WRONG_USE = 2;
    private static final String COMPLAINT = "arcomat: ";

    private boolean isFine() {
        return status == FINE;
    }

    /**
     * Fails the task unless all is well, with one sentence; what leads to it is in the log.
     *
     * @throws VerificationException where the models are not as they should be
     * @throws GradleException where the command could not do its work
     */
    void require(Logger log) {
        if (isFine()) {
            return;
        }
        tell(log);
        throw status == WRONG_USE ? failure() : new VerificationException(summary());
    }

    /**
     * The same for a task that makes what others work on: they are not to begin without it, not
     * even with {@code --continue}, which goes on after a {@link VerificationException}.
     *
     * @throws GradleException where the command could not do its work
     */
    void requireOutput(Logger log) {
        if (!isFine()) {
            tell(log);
            throw failure();
        }
    }

    private void tell(Logger log) {
        if (!out.isEmpty()) {
            log.error(out.stripTrailing());
        }
    }

    private GradleException failure() {
        return new GradleException(status == WRONG_USE ? complaint() : summary());
    }

    /** The last line, which says it all in short. */
    String summary() {
        List<String> lines = out.lines().filter(line -> !line.isBlank()).toList();
        return lines.isEmpty() ? "exit status " + status : lines.get(lines.size() - 1);
    }

    /** Whether there is more to tell than the last line does. */
    boolean hasDetails() {
        return out.lines().filter(line -> !line.isBlank()).count() > 1;
    }

    /** Why it could not do its work: how it was used, or what it could not read. */
    private String complaint() {
        return err.lines()
                .filter(line -> line.startsWith(COMPLAINT))
                .map(line -> line.substring(COMPLAINT.length()))
                .findFirst()
                .orElseGet(() -> out.isBlank() ? err.strip() : summary());
    }
}
