package arcomat.sim.memory;

/** How many bytes objects take in the memory of the brick, as leJOS lays them out. */
public final class ObjectLayout {
    /** Before the fields of an object and the elements of an array. */
    public static final int HEADER = 4;

    public static final int REFERENCE = 4;

    private static final int CHARACTER = 2;
    private static final int WORD = 4;

    /** Arrays of more elements have their length in a word behind the header. */
    private static final int SHORT_ARRAY = 254;

    private ObjectLayout() {}

    /**
     * Of a value in a field or in an array.
     *
     * @param descriptor of its type, as class files write it
     */
    public static int value(String descriptor) {
        return switch (descriptor.charAt(0)) {
            case 'Z', 'B' -> 1;
            case 'C', 'S' -> CHARACTER;
            case 'J', 'D' -> 8;
            default -> 4;
        };
    }

    /**
     * @param fields bytes of its fields
     */
    public static long object(long fields) {
        return aligned(Math.addExact(HEADER, fields));
    }

    /**
     * @param element bytes of each
     * @throws ArithmeticException if that is no number of 64 bits
     */
    public static long array(long length, int element) {
        long header = (long) HEADER + (length > SHORT_ARRAY ? WORD : 0);
        return aligned(Math.addExact(header, Math.multiplyExact(length, element)));
    }

    /**
     * A string with its characters.
     *
     * @param length number of characters
     */
    public static long text(long length) {
        return object(REFERENCE) + array(length, CHARACTER);
    }

    /** Objects begin at words. */
    public static long aligned(long bytes) {
        return (bytes + WORD - 1) / WORD * WORD;
    }
}
