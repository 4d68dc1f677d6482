package arcomat.analysis.search.external;

import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedNetwork.TooNarrow;

import com.carrotsearch.hppc.IntArrayList;

import java.util.Arrays;

/**
 * Pairs whose steps had to be computed, since nobody had met their like, in the order in which they
 * were: who expands them again learns the same, and gives the same numbers to it. Each is kept
 * field by field, whatever the layout.
 */
final class Lessons {
    private final IntArrayList values = new IntArrayList();
    private int fields = 1;
    private int next;

    static Lessons noted(Notes notes) {
        Lessons lessons = new Lessons();
        lessons.fields = (int) notes.next();
        for (long count = notes.next(); count > 0; count--) {
            lessons.values.add((int) notes.next());
        }
        return lessons;
    }

    void note(Notes notes) {
        notes.add(fields);
        notes.add(values.size());
        for (int i = 0; i < values.size(); i++) {
            notes.add(values.get(i));
        }
    }

    void add(PackedLayout layout, long[] pair) {
        fields = layout.fields();
        for (int field = 0; field < fields; field++) {
            values.add(layout.get(pair, field));
        }
    }

    /** Goes on to the next one; whether there is one. */
    boolean next() {
        next += fields;
        return next <= values.size();
    }

    /** Writes down the one that was gone on to. */
    void pack(PackedLayout layout, long[] into) {
        Arrays.fill(into, 0);
        for (int field = 0; field < fields; field++) {
            int value = values.get(next - fields + field);
            if (!layout.fits(field, value)) {
                throw new TooNarrow();
            }
            layout.put(into, field, value);
        }
    }
}
