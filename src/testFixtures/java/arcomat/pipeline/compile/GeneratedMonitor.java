package arcomat.pipeline.compile;

import arcomat.rt.Border;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.management.ManagementFactory;

/** An object of a generated monitor's class, and what its judgements have cost. */
final class GeneratedMonitor {
    private static final int MOST_CALLS = 10_000;

    private final com.sun.management.ThreadMXBean threads =
            (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    private final Object monitor;
    private final MethodHandle slice;
    private final long[] allocated = new long[MOST_CALLS];
    private int calls;

    GeneratedMonitor(Object monitor) {
        this.monitor = monitor;
        try {
            MethodType type = MethodType.methodType(boolean.class);
            slice =
                    MethodHandles.lookup()
                            .findVirtual(monitor.getClass(), "slice", type)
                            .bindTo(monitor);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    boolean slice() {
        try {
            long before = threads.getCurrentThreadAllocatedBytes();
            boolean kept = (boolean) slice.invokeExact();
            allocated[calls++] = threads.getCurrentThreadAllocatedBytes() - before;
            return kept;
        } catch (Throwable e) {
            throw new IllegalStateException(e);
        }
    }

    /** The bytes of all judgements but the first ones. */
    long allocatedAfter(int warm) {
        long sum = 0;
        for (int i = warm; i < calls; i++) {
            sum += allocated[i];
        }
        return sum;
    }

    void error() {
        call("error");
    }

    Border border() {
        return (Border) call("border");
    }

    String text(String method) {
        return (String) call(method);
    }

    private Object call(String method) {
        try {
            return monitor.getClass().getMethod(method).invoke(monitor);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }
}
