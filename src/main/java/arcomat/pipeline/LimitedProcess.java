package arcomat.pipeline;

import java.io.IOException;
import java.util.OptionalInt;
import java.util.concurrent.TimeUnit;

/** Somebody else's program, which is ended with its children when it has had enough time. */
public final class LimitedProcess {
    private LimitedProcess() {}

    /**
     * Runs a program to its end.
     *
     * @return its exit status; empty where it had to be ended
     * @throws InterruptedException where this thread is to stop; the program is ended, too
     */
    public static OptionalInt run(ProcessBuilder builder, int seconds)
            throws IOException, InterruptedException {
        Process process = builder.start();
        try {
            return process.waitFor(seconds, TimeUnit.SECONDS)
                    ? OptionalInt.of(process.exitValue())
                    : OptionalInt.empty();
        } finally {
            process.descendants().forEach(ProcessHandle::destroyForcibly);
            process.destroyForcibly();
        }
    }
}
