package arcomat.benchmarks.measure;

import java.io.IOException;
import java.util.List;

/** Commands as processes of their own, whose output nobody reads. */
public final class Command {
    private Command() {}

    /**
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
}
