package arcomat.editor.server;

import java.util.concurrent.ThreadFactory;

/**
 * Threads that nobody waits for at the end. Models nest as deep as their authors like, and what
 * follows them is recursive.
 *
 * @param name of the threads
 */
record DeepThreads(String name) implements ThreadFactory {
    private static final long STACK_BYTES = 512L << 20;

    @Override
    public Thread newThread(Runnable work) {
        Thread thread = new Thread(null, work, name, STACK_BYTES);
        thread.setDaemon(true);
        return thread;
    }
}
