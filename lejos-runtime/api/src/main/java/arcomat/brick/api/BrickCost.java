package arcomat.brick.api;

/**
 * What a program costs on the brick, in time and in memory. Measured on leJOS' own virtual machine
 * with linked robots: a run takes about these times, and in truth some 20 % more. They are for
 * questions like whether a slice fits into its cycle, not for clocks.
 */
public final class BrickCost {
    /** One instruction that is no call. */
    public static final int MICROSECONDS_PER_BYTECODE = 2;

    /** One call with its return, whatever the called method does then. */
    public static final int MICROSECONDS_PER_CALL = 8;

    /** What real runs took beyond the two costs above, in percent. */
    public static final int PERCENT_TOO_FAST = 20;

    /** What objects, arrays, strings and the stacks of threads have room in; code lies in flash. */
    public static final int HEAP_BYTES = 49_000;

    /** Calls that wait for each other in one thread; one more is a StackOverflowError. */
    public static final int FRAMES = 254;

    private BrickCost() {}
}
