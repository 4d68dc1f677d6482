package arcomat.syntax;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Supplier;

/**
 * Runs a task with room for every nesting that {@link NestingGuard} lets through: a recursive
 * parser takes about two kilobytes of stack for a level, and the caller's stack may be small.
 */
final class DeepStack {
    private static final long BYTES = 64L << 20;

    private DeepStack() {}

    /** Waits for the task, also where somebody interrupts. */
    static <T> T call(Supplier<T> task) {
        try {
            return CompletableFuture.supplyAsync(task, DeepStack::start).join();
        } catch (CompletionException e) {
            throw e.getCause() instanceof RuntimeException failure ? failure : e;
        }
    }

    private static void start(Runnable task) {
        new Thread(null, task, "deep syntax", BYTES).start();
    }
}
