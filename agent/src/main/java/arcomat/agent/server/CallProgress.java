package arcomat.agent.server;

import arcomat.pipeline.Progress;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/**
 * The work of a call, which ends when its time is up, or when nobody waits for it.
 *
 * @param limited has the end
 * @param over whether somebody else has answered
 */
record CallProgress(Progress limited, BooleanSupplier over) implements Progress {
    @Override
    public void step(String what) {
        limited.step(what);
    }

    @Override
    public void goOn() {
        limited.goOn();
        if (over.getAsBoolean()) {
            throw new CancellationException();
        }
    }
}
