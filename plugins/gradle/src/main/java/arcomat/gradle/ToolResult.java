package arcomat.gradle;

import arcomat.plugin.CommandResult;

import org.gradle.api.GradleException;
import org.gradle.api.logging.Logger;
import org.gradle.api.tasks.VerificationException;

/**
 * What came of a command, and what that means to a task.
 *
 * @param result of the tool
 */
record ToolResult(CommandResult result) {
    ToolResult(int status, String out, String err) {
        this(new CommandResult(status, out, err));
    }

    String out() {
        return result.out();
    }

    String err() {
        return result.err();
    }

    /**
     * Fails the task unless all is well, with one sentence; what leads to it is in the log.
     *
     * @throws VerificationException where the models are not as they should be
     * @throws GradleException where the command could not do its work
     */
    void require(Logger log) {
        if (result.isFine()) {
            return;
        }
        tell(log);
        throw result.isWrongUse() ? failure() : new VerificationException(result.failure());
    }

    /**
     * The same for a task that makes what others work on: they are not to begin without it, not
     * even with {@code --continue}, which goes on after a {@link VerificationException}.
     *
     * @throws GradleException where the command could not do its work
     */
    void requireOutput(Logger log) {
        if (!result.isFine()) {
            tell(log);
            throw failure();
        }
    }

    private void tell(Logger log) {
        if (!out().isEmpty()) {
            log.error(out().stripTrailing());
        }
    }

    private GradleException failure() {
        return new GradleException(result.failure());
    }

    /** The last line, which says it all in short. */
    String summary() {
        return result.summary();
    }

    /** Whether there is more to tell than the last line does. */
    boolean hasDetails() {
        return result.hasDetails();
    }
}
