package arcomat.analysis;

import java.util.function.BooleanSupplier;

/**
 * How much may be explored before the answer is unknown.
 *
 * @param timeIsUp asked now and then
 * @param states the most configurations, or pairs of them
 */
public record Budget(BooleanSupplier timeIsUp, long states) {
    /** Bytes of heap that one state is assumed to take. */
    private static final long PER_STATE = 400;

    /** No limit but the memory that there is. */
    public static Budget ofMemory() {
        return new Budget(
                () -> false, Math.max(100_000, Runtime.getRuntime().maxMemory() / PER_STATE));
    }

    /** Why to stop now, or null. */
    public String exhausted(long explored) {
        if (explored > states) {
            return "more than " + states + " states";
        }
        return (explored & 0xFF) == 0 && timeIsUp.getAsBoolean() ? "the time is up" : null;
    }
}
