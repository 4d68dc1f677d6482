package arcomat.sim.memory;

import java.util.Arrays;

/**
 * The calls of one thread of a program that wait for each other, as far as the brick's limits need
 * them: how many there are, what memory they take, and which objects their variables hold. The PC
 * forgets a variable as soon as nobody will read it, or later: that is left to its compiler. The
 * brick does not, and here it is the same in every run.
 */
public final class CallStack {
    private static final int INITIAL_SLOTS = 64;

    private final int most;
    private final int[] bases;
    private final int[] bytes;
    private Object[] slots = new Object[INITIAL_SLOTS];
    private int depth;
    private int top;

    /**
     * @param most calls that may wait for each other
     */
    public CallStack(int most) {
        this.most = most;
        this.bases = new int[most + 1];
        this.bytes = new int[most + 1];
    }

    /**
     * A method begins.
     *
     * @param variables of it that may hold objects
     * @param frame bytes that the call takes on the brick
     * @return the depth of the call, for {@link #caught}
     * @throws StackOverflowError where it is one too many
     */
    public int enter(int variables, int frame) {
        if (depth == most) {
            throw new StackOverflowError(
                    "the brick has room for %d calls in each other".formatted(most));
        }
        int end = top + variables;
        if (end > slots.length) {
            slots = Arrays.copyOf(slots, Math.max(end, 2 * slots.length));
        }
        Arrays.fill(slots, top, end, null);
        bytes[depth + 1] = bytes[depth] + frame;
        depth++;
        bases[depth] = top;
        top = end;
        return depth;
    }

    /** A method returns. */
    public void leave() {
        top = bases[depth];
        depth--;
    }

    /**
     * An error has been caught by the call at this depth; those above are gone.
     *
     * @param variables as for {@link #enter}
     */
    public void caught(int caller, int variables) {
        depth = caller;
        top = bases[caller] + variables;
    }

    /** A variable of the newest call holds an object, or null. */
    public void hold(Object object, int variable) {
        slots[bases[depth] + variable] = object;
    }

    /** What the calls take of the brick's memory. */
    int bytes() {
        return bytes[depth];
    }

    int top() {
        return top;
    }

    Object held(int slot) {
        return slots[slot];
    }
}
