package arcomat.sim.inside;

import arcomat.sim.device.Hardware;
import arcomat.sim.time.Strand;
import arcomat.sim.time.VirtualTime;

import org.jspecify.annotations.Nullable;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * Stands in for locks of objects. The PC's own would block a thread that has the baton, and with it
 * everybody; and who gets a lock first would be left to chance.
 */
public final class BrickMonitors {
    private static final Hardware BRICK = Hardware.of(BrickMonitors.class);

    /** Microseconds between two attempts to get a lock that another thread holds. */
    private static final long RETRY = 100;

    private static final Map<Object, Monitor> MONITORS = new IdentityHashMap<>();
    private static final ArrayDeque<Monitor> SPARE = new ArrayDeque<>();

    private BrickMonitors() {}

    private static final class Monitor {
        private @Nullable Strand owner;
        private int depth;
        private final List<Waiter> waiters = new ArrayList<>();
    }

    private static final class Waiter {
        private boolean notified;
    }

    public static void enter(Object object) {
        enter(object, 1);
    }

    private static void enter(Object object, int depth) {
        VirtualTime time = BRICK.called().time();
        Monitor monitor = monitor(object);
        while (monitor.owner != null && monitor.owner != time.running()) {
            time.spend(RETRY);
            monitor = monitor(object);
        }
        monitor.owner = time.running();
        monitor.depth += depth;
    }

    private static Monitor monitor(Object object) {
        Monitor monitor = MONITORS.get(object);
        if (monitor == null) {
            monitor = SPARE.isEmpty() ? new Monitor() : SPARE.pop();
            MONITORS.put(object, monitor);
        }
        return monitor;
    }

    public static void exit(Object object) {
        Monitor monitor = owned(object);
        monitor.depth--;
        if (monitor.depth == 0) {
            leave(object, monitor);
        }
    }

    private static void leave(Object object, Monitor monitor) {
        monitor.owner = null;
        if (monitor.waiters.isEmpty()) {
            MONITORS.remove(object);
            SPARE.push(monitor);
        }
    }

    public static void wait(Object object) throws InterruptedException {
        wait(object, 0);
    }

    /** Gives the lock away until notified, for so many milliseconds at most; 0 sets no limit. */
    public static void wait(Object object, long milliseconds) throws InterruptedException {
        Monitor monitor = owned(object);
        Waiter waiter = new Waiter();
        int depth = monitor.depth;
        long end = milliseconds == 0 ? Long.MAX_VALUE : BRICK.milliseconds() + milliseconds;
        monitor.waiters.add(waiter);
        monitor.depth = 0;
        monitor.owner = null;
        try {
            while (!waiter.notified && BRICK.milliseconds() < end) {
                BRICK.time().waitInterruptibly(BRICK.tickAfter(1));
            }
        } finally {
            monitor.waiters.remove(waiter);
            enter(object, depth);
        }
    }

    /** The brick's clock knows no nanoseconds. */
    public static void wait(Object object, long milliseconds, int nanoseconds)
            throws InterruptedException {
        wait(object, milliseconds);
    }

    public static void notify(Object object) {
        for (Waiter waiter : owned(object).waiters) {
            if (!waiter.notified) {
                waiter.notified = true;
                return;
            }
        }
    }

    public static void notifyAll(Object object) {
        owned(object).waiters.forEach(waiter -> waiter.notified = true);
    }

    private static Monitor owned(Object object) {
        Monitor monitor = MONITORS.get(object);
        if (monitor == null || monitor.owner != BRICK.time().running()) {
            throw new IllegalMonitorStateException("the thread does not hold the object's lock");
        }
        return monitor;
    }
}
