package arcomat.sim.device;

import arcomat.sim.time.Strand;
import arcomat.sim.time.VirtualTime;

/**
 * What computing costs. The brick has one processor: while a thread computes, the others wait.
 * Threads collect what they have computed and let it pass when somebody could see it, or when they
 * would be interrupted anyway.
 *
 * <p>What a program computes before it first looks at the clock belongs to switching on, up to a
 * limit: so the first slice of a robot begins at 0.
 */
public final class Processor {
    /**
     * Microseconds that a call of a device takes: enough for a loop that only asks to see time
     * pass.
     */
    public static final long CALL = 20;

    /**
     * Microseconds that one round of a loop takes at least, where nothing else is counted: without
     * it an empty loop would stop time.
     */
    public static final long ROUND = 10;

    /** Microseconds after which another thread has its turn. */
    private static final long TURN = 1000;

    /** Microseconds of computing that belong to switching on. */
    private static final long START = 10_000;

    private final VirtualTime time;
    private final boolean counted;
    private long limit = START;
    private long busyUntil;
    private boolean started;

    Processor(VirtualTime time, boolean counted) {
        this.time = time;
        this.counted = counted;
    }

    /** The calling thread computes for so many microseconds, and cannot be interrupted just now. */
    public void count(long microseconds) {
        time.running().work(microseconds);
    }

    /** The calling thread computes for so many microseconds. */
    public void work(long microseconds) {
        if (time.running().work(microseconds) >= limit) {
            begin();
            pass();
        }
    }

    /** A device is called. */
    void call() {
        if (counted && started) {
            time.running().work(CALL);
            pass();
        } else {
            time.spend(CALL);
        }
    }

    /** The program looks at the clock. */
    void look() {
        if (!started && time.running() != null) {
            time.running().takeWork();
            begin();
        }
    }

    /** The program is about to wait. */
    void rest() {
        look();
        pass();
    }

    private void begin() {
        started = true;
        limit = TURN;
    }

    private void pass() {
        Strand strand = time.running();
        long work = strand.takeWork();
        if (work > 0) {
            busyUntil = Math.max(busyUntil, time.now()) + work;
            time.waitUntil(busyUntil);
        }
    }
}
