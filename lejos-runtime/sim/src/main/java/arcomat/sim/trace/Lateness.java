package arcomat.sim.trace;

/**
 * How often a program came late: rounds of its main loop that took longer than they should.
 *
 * @param slices how many
 * @param longest microseconds that the longest of them took
 */
public record Lateness(int slices, long longest) {
    public static final Lateness NONE = new Lateness(0, 0);

    /** With one more. */
    public Lateness and(long microseconds) {
        return new Lateness(slices + 1, Math.max(longest, microseconds));
    }
}
