package arcomat.generate.template;

import org.jspecify.annotations.Nullable;

import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Somebody else's work, done in a thread of its own, one piece after the other. One that takes too
 * long is interrupted, and left alone if that does not help.
 */
final class LimitedWork {
    private static final long STACK_BYTES = 64L << 20;

    private final Duration limit;
    private @Nullable ThreadPoolExecutor worker;

    LimitedWork(Duration limit) {
        this.limit = limit;
    }

    /**
     * The result of a piece of work.
     *
     * @throws TimeoutException where it has taken too long
     * @throws ExecutionException where it has failed, with the reason
     */
    <T> T run(Callable<T> work) throws TimeoutException, ExecutionException {
        ThreadPoolExecutor current = worker == null ? worker() : worker;
        worker = current;
        Future<T> result = current.submit(work);
        try {
            return result.get(limit.toMillis(), TimeUnit.MILLISECONDS);
        } catch (TimeoutException e) {
            leave(current);
            throw e;
        } catch (InterruptedException e) {
            leave(current);
            Thread.currentThread().interrupt();
            throw new TimeoutException("interrupted");
        }
    }

    private void leave(ThreadPoolExecutor current) {
        current.shutdownNow();
        worker = null;
    }

    /** Its thread ends by itself when there is no more work. */
    private static ThreadPoolExecutor worker() {
        ThreadPoolExecutor worker =
                new ThreadPoolExecutor(
                        1,
                        1,
                        1,
                        TimeUnit.SECONDS,
                        new LinkedBlockingQueue<>(),
                        LimitedWork::thread);
        worker.allowCoreThreadTimeOut(true);
        return worker;
    }

    private static Thread thread(Runnable work) {
        Thread thread = new Thread(null, work, "arcomat-template", STACK_BYTES);
        thread.setDaemon(true);
        return thread;
    }
}
