package arcomat.benchmarks.measure;

import com.sun.management.ThreadMXBean;

import java.lang.management.ManagementFactory;

/** How much memory work takes from the heap in its steady state. */
public final class Allocation {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private Allocation() {}

    /**
     * @param runs how often to repeat the work, after as many runs to warm up
     * @param steps steps in one run
     * @throws IllegalStateException if anything was allocated
     */
    public static String perRun(int runs, int steps, Runnable work) {
        repeat(runs, work);
        long before = THREADS.getCurrentThreadAllocatedBytes();
        repeat(runs, work);
        long bytes = THREADS.getCurrentThreadAllocatedBytes() - before;
        if (bytes != 0) {
            throw new IllegalStateException(bytes + " bytes were allocated");
        }
        return "%d bytes allocated in %,d steps".formatted(bytes, (long) runs * steps);
    }

    private static void repeat(int runs, Runnable work) {
        for (int i = 0; i < runs; i++) {
            work.run();
        }
    }
}
