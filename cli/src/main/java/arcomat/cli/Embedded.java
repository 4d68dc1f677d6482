package arcomat.cli;

import arcomat.cli.terminal.Console;

import java.io.BufferedReader;
import java.io.PrintWriter;
import java.io.Reader;
import java.nio.file.Path;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;

/**
 * The command inside another program, such as a build. Nothing but types of the JDK is in its
 * signature, so that a caller need not be compiled against the tool, and can take whatever version
 * of it a user names.
 */
public final class Embedded {
    private Embedded() {}

    /**
     * Runs a command as a process would, without colours and progress.
     *
     * @param directory the folder that relative paths start from, and are shown from
     * @param out results
     * @param err complaints about the use of the command
     * @return the exit status: 0 fine; 1 findings; 2 wrong use; 3 unknown
     * @throws InterruptedException if the caller is not to wait any longer
     */
    public static int run(Path directory, PrintWriter out, PrintWriter err, String... arguments)
            throws InterruptedException {
        BufferedReader nothing = new BufferedReader(Reader.nullReader());
        Console console = Console.quiet(directory, out, err, nothing);
        FutureTask<Integer> work = new FutureTask<>(() -> Cli.run(arguments, console));
        Main.thread(work).start();
        try {
            return work.get();
        } catch (ExecutionException e) {
            throw new IllegalStateException(e.getCause());
        }
    }
}
