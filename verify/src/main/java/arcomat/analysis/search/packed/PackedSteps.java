package arcomat.analysis.search.packed;

import arcomat.semantics.expression.Sent;

/**
 * All ways in which a network goes on, in one layout: from a configuration, with an input, one way
 * after the other, in the order in which the unfolding has them.
 */
public interface PackedSteps {
    /** Takes a configuration, which has not ended. */
    void begin(long[] configuration);

    /** A number for how the configuration that was taken looks at inputs from outside. */
    long looks();

    /**
     * Takes an input.
     *
     * @param letter as {@link PackedNetwork#letter} has it
     */
    void read(int[] letter);

    /** Goes on to the next way, if there is one. */
    boolean next();

    /** Whether the run has ended on this way. */
    boolean hasEnded();

    /** Writes down where this way leads to. */
    void after(long[] into);

    /** What is shown on this way, in one number. */
    long shown();

    /** What is shown on a signal that is observed. */
    Sent shown(long number, int signal);
}
