package arcomat.sim.time;

import arcomat.brick.api.BrickCost;
import arcomat.sim.memory.CallStack;

import org.jspecify.annotations.Nullable;

import java.util.concurrent.locks.LockSupport;

/**
 * A thread that takes part in virtual time. It runs only while it has the baton; it gives the baton
 * away by waiting.
 */
public final class Strand extends Actor {
    /** A program that catches every end it is sent is left behind, parked for good. */
    private static final int PATIENCE = 1000;

    private @Nullable Thread thread;
    private volatile boolean hasBaton;
    private boolean ended;
    private boolean interrupted;
    private boolean interruptible;
    private int refusals;
    private final CallStack calls = new CallStack(BrickCost.FRAMES);
    private long work;

    Strand(Rank rank) {
        super(rank);
    }

    /** The calls of the program that wait for each other. */
    public CallStack calls() {
        return calls;
    }

    /**
     * Computes for so many microseconds, which do not pass yet.
     *
     * @return what has come together
     */
    public long work(long microseconds) {
        work += microseconds;
        return work;
    }

    /** What has come together, which is then forgotten. */
    public long takeWork() {
        long taken = work;
        work = 0;
        return taken;
    }

    void runsOn(Thread carrier) {
        thread = carrier;
    }

    /** Blocks until somebody hands over the baton. */
    void awaitBaton() {
        while (!hasBaton) {
            LockSupport.park(this);
        }
        hasBaton = false;
    }

    /** Like {@link #awaitBaton}, up to a moment of the PC's clock; false if it came first. */
    boolean awaitBatonUntil(long nanoTime) {
        while (!hasBaton) {
            long rest = nanoTime - System.nanoTime();
            if (rest <= 0) {
                return false;
            }
            LockSupport.parkNanos(this, rest);
        }
        hasBaton = false;
        return true;
    }

    void giveBaton() {
        hasBaton = true;
        LockSupport.unpark(thread);
    }

    boolean isEnded() {
        return ended;
    }

    /** From now on every wait of this strand unwinds it. */
    void end() {
        ended = true;
    }

    /** Whether this strand was told to end so often that telling it again is useless. */
    boolean refusesToEnd() {
        return ++refusals > PATIENCE;
    }

    boolean isInterrupted() {
        return interrupted;
    }

    boolean isInterruptible() {
        return interruptible;
    }

    void setInterruptible(boolean interruptible) {
        this.interruptible = interruptible;
    }

    void setInterrupted(boolean interrupted) {
        this.interrupted = interrupted;
    }
}
