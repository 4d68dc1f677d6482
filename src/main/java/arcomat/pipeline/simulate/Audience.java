package arcomat.pipeline.simulate;

import arcomat.report.run.RunText;

import java.util.function.BooleanSupplier;

/**
 * Who looks at a run while it goes on.
 *
 * @param text is told of every step
 * @param present whether anybody still reads it
 */
public record Audience(RunText text, BooleanSupplier present) {
    /** Whoever has asked takes the whole run at its end. */
    static final Audience NOBODY = new Audience(RunText.NOTHING, () -> true);

    /** As often the audience is asked whether it is still there. */
    private static final int STEPS_BETWEEN = 256;

    boolean staysAfter(int step) {
        return step % STEPS_BETWEEN != 0 || present.getAsBoolean();
    }
}
