package arcomat.pipeline.brick;

import arcomat.sim.device.SilentObserver;

import java.lang.management.ManagementFactory;

/** What a program's own thread allocates, once everything has been loaded and said. */
final class AllocationObserver extends ForwardingObserver {
    private static final int WARM = 100;

    private final com.sun.management.ThreadMXBean threads =
            (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    private int cycles;
    private long earlier;
    private long later;

    AllocationObserver() {
        super(new SilentObserver());
    }

    @Override
    public void slept(long from, long until) {
        later = threads.getCurrentThreadAllocatedBytes();
        if (cycles++ == WARM) {
            earlier = later;
        }
    }

    int cycles() {
        return cycles;
    }

    long bytes() {
        return later - earlier;
    }
}
