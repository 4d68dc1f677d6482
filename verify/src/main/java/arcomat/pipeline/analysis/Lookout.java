package arcomat.pipeline.analysis;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.lang.ref.WeakReference;
import java.util.Comparator;
import java.util.Optional;

/**
 * Looks at the clock and at the heap while somebody else searches, so that the search has only to
 * read two flags, as often as it likes. The heap counts as full when what is left after a garbage
 * collection is nearly all of it: what is used in between may be garbage.
 */
final class Lookout {
    /** There has to be enough left to end with an answer, and to let tables grow until then. */
    private static final double FULL = 0.8;

    private static final long MILLISECONDS_BETWEEN = 20;

    private volatile boolean late;
    private volatile boolean full;

    private Lookout() {}

    /**
     * Looks out for as long as somebody asks.
     *
     * @param end when it is late, as {@link System#nanoTime} tells it; never if empty
     */
    static Lookout post(Optional<Long> end) {
        Lookout lookout = new Lookout();
        WeakReference<Lookout> posted = new WeakReference<>(lookout);
        Thread thread = new Thread(() -> look(posted, end), "arcomat-lookout");
        thread.setDaemon(true);
        thread.start();
        return lookout;
    }

    boolean isLate() {
        return late;
    }

    boolean isFull() {
        return full;
    }

    private static void look(WeakReference<Lookout> posted, Optional<Long> end) {
        try {
            while (posted.get() != null) {
                Thread.sleep(MILLISECONDS_BETWEEN);
                Lookout lookout = posted.get();
                if (lookout != null) {
                    lookout.late |= end.isPresent() && System.nanoTime() - end.get() >= 0;
                    lookout.full |= isHeapFull();
                }
            }
        } catch (InterruptedException ended) {
            Thread.currentThread().interrupt();
        } catch (OutOfMemoryError here) {
            Lookout lookout = posted.get();
            if (lookout != null) {
                lookout.full = true;
            }
        }
    }

    /** The long look, at what survives collections, only where the quick one gives cause. */
    private static boolean isHeapFull() {
        Runtime runtime = Runtime.getRuntime();
        double used = runtime.totalMemory() - runtime.freeMemory();
        return used > FULL / 2 * runtime.maxMemory() && isFull(afterCollection());
    }

    private static Optional<MemoryUsage> afterCollection() {
        return ManagementFactory.getMemoryPoolMXBeans().stream()
                .filter(pool -> pool.getType() == MemoryType.HEAP)
                .map(MemoryPoolMXBean::getCollectionUsage)
                .filter(usage -> usage != null && usage.getMax() > 0)
                .max(Comparator.comparingLong(MemoryUsage::getMax));
    }

    private static boolean isFull(Optional<MemoryUsage> usage) {
        return usage.isPresent() && usage.get().getUsed() > FULL * usage.get().getMax();
    }
}
