package arcomat.analysis.search.packed;

import java.util.Arrays;

/** Where numbers stand in some words: each has as many bits as it needs, and lies in one word. */
public final class PackedLayout {
    private final int[] widths;
    private final int[] places;
    private final int[] shifts;
    private final int words;

    private PackedLayout(int[] widths, int[] places, int[] shifts, int words) {
        this.widths = widths;
        this.places = places;
        this.shifts = shifts;
        this.words = words;
    }

    /**
     * @param widths bits per field, fewer than 32; none for what is always 0
     */
    public static PackedLayout of(int[] widths) {
        int[] places = new int[widths.length];
        int[] shifts = new int[widths.length];
        int word = 0;
        int used = 0;
        for (int field = 0; field < widths.length; field++) {
            if (used + widths[field] > Long.SIZE) {
                word++;
                used = 0;
            }
            places[field] = word;
            shifts[field] = widths[field] == 0 ? 0 : used;
            used += widths[field];
        }
        return new PackedLayout(widths.clone(), places, shifts, word + 1);
    }

    /** How many words it takes. */
    public int words() {
        return words;
    }

    public int get(long[] from, int field) {
        return (int) (from[places[field]] >>> shifts[field]) & (1 << widths[field]) - 1;
    }

    /** How many fields there are. */
    public int fields() {
        return widths.length;
    }

    /** The bits of a field. */
    public int width(int field) {
        return widths[field];
    }

    /** Whether all fields stand where they do in another layout. */
    public boolean hasWidthsOf(PackedLayout other) {
        return Arrays.equals(widths, other.widths);
    }

    int word(int field) {
        return places[field];
    }

    int shift(int field) {
        return shifts[field];
    }

    /** Sets a field that is 0. */
    public void put(long[] into, int field, int value) {
        into[places[field]] |= (long) value << shifts[field];
    }

    /** Sets a field to 0. */
    public void clear(long[] into, int field) {
        into[places[field]] &= ~(((1L << widths[field]) - 1) << shifts[field]);
    }

    /** Whether a field has bits enough for a value. */
    public boolean fits(int field, int value) {
        return value >>> widths[field] == 0;
    }

    /** The same fields in another layout; into what is 0. */
    public void move(long[] from, PackedLayout to, long[] into) {
        for (int field = 0; field < widths.length; field++) {
            to.put(into, field, get(from, field));
        }
    }
}
