package arcomat.sim.time;

import java.util.concurrent.Executor;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * Threads of the PC that carry strands: as many as there are strands with calls that wait for each
 * other. One that carries none is kept for a while, for the next one.
 */
public final class Carriers implements Executor {
    private static final int KEPT_MILLISECONDS = 500;

    private final ThreadPoolExecutor threads;

    public Carriers() {
        threads =
                new ThreadPoolExecutor(
                        0,
                        Integer.MAX_VALUE,
                        KEPT_MILLISECONDS,
                        TimeUnit.MILLISECONDS,
                        new SynchronousQueue<>(),
                        Carriers::thread);
    }

    private static Thread thread(Runnable work) {
        Thread thread = new Thread(null, work, "brick");
        thread.setDaemon(true); // a program that cannot be ended must not keep the PC's process
        return thread;
    }

    @Override
    public void execute(Runnable work) {
        threads.execute(work);
    }
}
