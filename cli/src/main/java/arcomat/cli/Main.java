package arcomat.cli;

import arcomat.cli.terminal.Console;

/** Entry point of the command {@code arcomat}. */
public final class Main {
    /**
     * Models nest as deep as their authors like; what follows them is recursive. The room is
     * reserved, not taken: a page that is not reached costs nothing.
     */
    private static final long STACK_BYTES = 512L << 20;

    private Main() {}

    public static void main(String[] args) {
        Runnable work = () -> System.exit(Cli.run(args, Console.ofProcess()));
        thread(work).start();
    }

    /** A thread with room for deep models, not yet started. */
    static Thread thread(Runnable work) {
        return new Thread(null, work, "arcomat", STACK_BYTES);
    }
}
