package arcomat.sim.device;

import java.util.BitSet;

/** The lines that one object of a program has come to, of those that are noted. */
public final class LineNotes {
    private final Object object;
    private final boolean[] reached;

    /**
     * @param reached is written by the program, by the numbers of lines
     */
    LineNotes(Object object, boolean[] reached) {
        this.object = object;
        this.reached = reached;
    }

    /** The program's own, to be looked at. */
    public Object object() {
        return object;
    }

    /** The numbers of the lines. */
    public BitSet numbers() {
        BitSet numbers = new BitSet(reached.length);
        for (int number = 0; number < reached.length; number++) {
            numbers.set(number, reached[number]);
        }
        return numbers;
    }
}
