package arcomat.cli.terminal;

import arcomat.pipeline.Progress;

import java.io.PrintWriter;

/** Says on a side channel what is being done, once a command has been at work for a second. */
public final class ProgressLines implements Progress, AutoCloseable {
    private static final long PATIENCE_MILLIS = 1000;

    private final PrintWriter out;
    private String current = "";
    private boolean done;

    public ProgressLines(PrintWriter out) {
        this.out = out;
        Thread thread = new Thread(this::watch, "progress");
        thread.setDaemon(true);
        thread.start();
    }

    @Override
    public synchronized void step(String what) {
        current = what;
    }

    private synchronized void watch() {
        String last = "";
        try {
            while (!done) {
                wait(PATIENCE_MILLIS);
                if (!done && !current.equals(last)) {
                    out.println(current + " ...");
                    out.flush();
                    last = current;
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public synchronized void close() {
        done = true;
        notifyAll();
    }
}
