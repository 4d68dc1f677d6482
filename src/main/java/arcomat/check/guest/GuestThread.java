package arcomat.check.guest;

import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Somebody else's work in a thread of its own. One that takes too long is interrupted, and left
 * alone if that does not help; it does not keep the process from its end.
 *
 * @param limit after which nobody waits any longer
 */
public record GuestThread(String guest, Duration limit) {
    /** The same room for deep models as the tool's own thread has. */
    private static final long STACK_BYTES = 512L << 20;

    /**
     * The result of the work.
     *
     * @throws TimeoutException where it has taken too long
     * @throws ExecutionException where it has failed, with the reason
     * @throws CancellationException where who waits is interrupted
     */
    public <T> T call(Callable<T> work) throws TimeoutException, ExecutionException {
        FutureTask<T> task = new FutureTask<>(work);
        Thread thread = new Thread(null, task, "guest " + guest, STACK_BYTES);
        thread.setDaemon(true);
        thread.start();
        try {
            return task.get(limit.toMillis(), TimeUnit.MILLISECONDS);
        } catch (TimeoutException e) {
            task.cancel(true);
            throw e;
        } catch (InterruptedException e) {
            task.cancel(true);
            Thread.currentThread().interrupt();
            throw new CancellationException();
        }
    }
}
