package arcomat.sim.time;

import arcomat.brick.api.BrickCost;
import arcomat.sim.memory.CallStack;

import org.jspecify.annotations.Nullable;

import java.util.concurrent.Executor;
import java.util.concurrent.locks.LockSupport;

/**
 * A thread that takes part in virtual time. It runs only while it has the baton; it gives the baton
 * away by waiting.
 *
 * <p>As long as calls of it wait for each other, it is carried by a thread of the PC. Before it has
 * begun, and while it rests, there is nothing to keep on a stack, and any thread may carry it next.
 */
public final class Strand extends Actor {
    /** A program that catches every end it is sent is left behind, parked for good. */
    private static final int PATIENCE = 1000;

    private final String name;
    private final Runnable body;
    private final Executor carriers;
    private final SavedVariables saved = new SavedVariables();
    private @Nullable Thread thread;
    private boolean rests;
    private boolean resumes;
    private volatile boolean hasBaton;
    private boolean ended;
    private boolean interrupted;
    private boolean interruptible;
    private int refusals;
    private final CallStack calls = new CallStack(BrickCost.FRAMES);
    private long work;

    /**
     * @param body called once, and again each time it goes on after a rest
     * @param carriers whose threads may carry it
     */
    Strand(Rank rank, String name, Runnable body, Executor carriers) {
        super(rank);
        this.name = name;
        this.body = body;
        this.carriers = carriers;
    }

    public String name() {
        return name;
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

    /** What its calls save when they are left for a rest. */
    public SavedVariables saved() {
        return saved;
    }

    /** Whether its calls have to be left, up to its body, since it has begun to rest. */
    public boolean rests() {
        return rests;
    }

    /** Whether its calls have to be entered again where they were left. */
    public boolean resumes() {
        return resumes;
    }

    /** The innermost call has been entered again. */
    public void resumed() {
        resumes = false;
    }

    void rest() {
        rests = true;
    }

    boolean isCarried() {
        return thread != null;
    }

    /** Its next carrier begins with this. */
    void beCarried(Runnable by) {
        carriers.execute(by);
    }

    /**
     * Goes on with the calling thread, up to its end or its next rest.
     *
     * @return whether it rests
     */
    boolean goOn() {
        Thread carrier = Thread.currentThread();
        if (!rests) {
            carrier.setName(name);
        }
        thread = carrier;
        resumes = rests;
        rests = false;
        try {
            // One that was told to end before it has begun does not begin.
            if (resumes || !ended) {
                body.run();
            }
        } finally {
            thread = null;
        }
        return rests;
    }

    /** It is the calling thread that is the strand, and no other will ever carry it. */
    void isCaller() {
        thread = Thread.currentThread();
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
