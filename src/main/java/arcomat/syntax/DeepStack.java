package arcomat.syntax;

import java.util.function.Supplier;

/**
 * Runs a task with room for every nesting that {@link NestingGuard} lets through: a recursive
 * parser takes about two kilobytes of stack for a level, and the caller's stack may be small.
 */
final class DeepStack {
    private static final long BYTES = 64L << 20;

    private DeepStack() {}

    static <T> T call(Supplier<T> task) {
        Result<T> result = new Result<>(task);
        Thread thread = new Thread(null, result, "deep syntax", BYTES);
        thread.start();
        result.await(thread);
        return result.value;
    }

    private static final class Result<T> implements Runnable {
        private final Supplier<T> task;
        private T value;
        private RuntimeException failure;

        Result(Supplier<T> task) {
            this.task = task;
        }

        @Override
        public void run() {
            try {
                value = task.get();
            } catch (RuntimeException e) {
                failure = e;
            }
        }

        void await(Thread thread) {
            boolean interrupted = false;
            while (thread.isAlive()) {
                try {
                    thread.join();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
            if (failure != null) {
                throw failure;
            }
        }
    }
}
