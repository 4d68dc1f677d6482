package arcomat.pipeline.watch;

import arcomat.analysis.search.Budget;
import arcomat.pipeline.Progress;

import java.util.concurrent.CancellationException;

/** Ends work that nobody waits for any longer, at its next step. */
final class Interruption implements Progress {
    private volatile boolean ended;

    /** From any thread. */
    void end() {
        ended = true;
    }

    boolean isEnded() {
        return ended;
    }

    @Override
    public void step(String what) {
        goOn();
    }

    /**
     * @throws CancellationException where the work is to end
     */
    @Override
    public void goOn() {
        if (ended) {
            throw new CancellationException("a newer save has come");
        }
    }

    /** The same limits, which end with the work. */
    Budget within(Budget limits) {
        return new Budget(
                () -> ended || limits.timeIsUp().getAsBoolean(),
                limits.memoryIsFull(),
                limits.states());
    }
}
