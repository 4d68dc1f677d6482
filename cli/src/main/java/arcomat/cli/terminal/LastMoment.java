package arcomat.cli.terminal;

import java.util.concurrent.TimeUnit;

/**
 * Ends the process where work does not end by itself, though its time has been up for a while. What
 * is written to files is written at once or not at all.
 */
public final class LastMoment {
    /** In which work looks at the clock, says what it found, and writes it. */
    private static final long GRACE = TimeUnit.SECONDS.toNanos(10);

    private LastMoment() {}

    /**
     * @param end when the time is up, as {@link System#nanoTime} tells it
     */
    public static void await(long end, Console console) {
        Thread thread = new Thread(() -> haltAt(end + GRACE, console), "arcomat-last-moment");
        thread.setDaemon(true);
        thread.start();
    }

    private static void haltAt(long end, Console console) {
        try {
            TimeUnit.NANOSECONDS.sleep(end - System.nanoTime());
        } catch (InterruptedException ended) {
            return;
        }
        console.err().println("arcomat: unknown: the time is up; allow it more with --timeout");
        console.err().flush();
        console.halt().accept(ExitStatus.UNKNOWN);
    }
}
