package arcomat.pipeline;

import java.util.concurrent.CancellationException;

/** Ends work that nobody waits for any longer, at its next step. */
public final class Interruption implements Progress {
    private volatile boolean ended;

    /** From any thread. */
    public void end() {
        ended = true;
    }

    public boolean isEnded() {
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
            throw new CancellationException("nobody waits for it any longer");
        }
    }
}
