package arcomat.sim.inside;

import arcomat.sim.device.Hardware;
import arcomat.sim.device.Lifetime;

/** Stands in for what java.lang.Thread does with the scheduler of the PC. */
public final class BrickThreads {
    private static final Hardware BRICK = Hardware.of(BrickThreads.class);

    private BrickThreads() {}

    public static void start(Thread thread) {
        lifetime().start(thread);
    }

    public static boolean isAlive(Thread thread) {
        return lifetime().isAlive(thread);
    }

    public static void setDaemon(Thread thread, boolean on) {
        lifetime().setDaemon(thread, on);
    }

    public static boolean isDaemon(Thread thread) {
        return lifetime().isDaemon(thread);
    }

    public static Thread currentThread() {
        return lifetime().current();
    }

    public static void join(Thread thread) throws InterruptedException {
        join(thread, 0);
    }

    /** Waits for the end of a thread, so many milliseconds at most; 0 means as long as it takes. */
    public static void join(Thread thread, long milliseconds) throws InterruptedException {
        long end = milliseconds == 0 ? Long.MAX_VALUE : BRICK.milliseconds() + milliseconds;
        while (lifetime().isAlive(thread) && BRICK.milliseconds() < end) {
            BRICK.time().waitInterruptibly(BRICK.tickAfter(1));
        }
    }

    public static void interrupt(Thread thread) {
        lifetime().interrupt(thread);
    }

    public static boolean isInterrupted(Thread thread) {
        return lifetime().isInterrupted(thread);
    }

    public static boolean interrupted() {
        return BRICK.called().time().clearInterrupt();
    }

    public static void sleep(long milliseconds) throws InterruptedException {
        BRICK.sleepInterruptibly(milliseconds);
    }

    @SuppressWarnings("NamedLikeContextualKeyword") // as in Thread
    public static void yield() {
        BRICK.called();
    }

    private static Lifetime lifetime() {
        return BRICK.called().lifetime();
    }
}
