package arcomat.sim.time;

import org.jspecify.annotations.Nullable;

import java.time.Duration;

/**
 * The clock where programs have threads.
 *
 * <p>Not thread-safe by locks but by the baton: exactly one strand runs at any moment, and only
 * that one calls anything here.
 */
public final class ThreadedTime extends VirtualTime {
    private @Nullable Duration patience;
    private long started;
    private boolean abandoned;

    /** What went wrong in the world while no strand was carried; the controller is told. */
    private @Nullable Throwable failure;

    @Override
    public void runUntil(long moment) {
        controller().isCaller();
        super.runUntil(moment);
        Throwable told = failure;
        if (told != null) {
            failure = null;
            throw new IllegalStateException(told);
        }
    }

    @Override
    void giveWay(Strand caller, Strand next) {
        handOver(next);
        await(caller);
    }

    private void handOver(Strand next) {
        if (next.isCarried()) {
            next.giveBaton();
        } else {
            next.beCarried(() -> carry(next));
        }
    }

    /** As long as strands follow each other that nobody carries, one thread carries them all. */
    private void carry(Strand first) {
        Strand next = first;
        try {
            while (!next.isCarried()) {
                goOn(next);
                next = advance();
            }
        } catch (RuntimeException | Error e) {
            failure = e;
            returnToController();
            next = controller();
        }
        next.giveBaton();
    }

    private void goOn(Strand strand) {
        boolean rests = false;
        try {
            rests = strand.goOn();
        } finally {
            if (!rests) {
                remove(strand);
            }
        }
    }

    /** Programs that never wait would keep whoever steers the run for ever. */
    private void await(Strand strand) {
        if (strand != controller() || patience == null) {
            strand.awaitBaton();
        } else if (!strand.awaitBatonUntil(started + patience.toNanos())) {
            abandoned = true;
            throw new OutOfPatience(patience);
        }
    }

    /**
     * From now on the controller waits so long by the PC's clock, all in all.
     *
     * @see OutOfPatience
     */
    public void limit(Duration newPatience) {
        started = System.nanoTime();
        patience = newPatience;
    }

    /** Whether the controller has given up: programs may still be running, for good. */
    public boolean isAbandoned() {
        return abandoned;
    }

    @Override
    void leaveBehind(Strand strand) {
        super.leaveBehind(strand);
        handOver(advance());
        strand.awaitBaton(); // for ever
    }
}
