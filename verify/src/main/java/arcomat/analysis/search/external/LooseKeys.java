package arcomat.analysis.search.external;

import arcomat.analysis.search.external.ExternalMemory.Volume;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedTable;

import java.util.List;

/** Keys that are in no pair; some may be there more than once. */
final class LooseKeys {
    private final ExternalMemory memory;
    private final int words;
    private final int capacity;
    private Records keys;

    /** Those that came last: they are not kept again. */
    private PackedTable known;

    /**
     * @param capacity so many are recognised
     */
    LooseKeys(ExternalMemory memory, int words, int capacity) {
        this.memory = memory;
        this.words = words;
        this.capacity = capacity;
        keys = new Records(memory, words, 0);
        known = new PackedTable(words);
    }

    static LooseKeys noted(Notes notes, ExternalMemory memory, int words, int capacity) {
        LooseKeys loose = new LooseKeys(memory, words, capacity);
        loose.keys = Records.noted(notes, memory, words, 0);
        return loose;
    }

    void note(Notes notes, List<Volume> kept) {
        keys.note(notes, kept);
    }

    void add(long[] key) {
        if (known.size() == capacity) {
            known = new PackedTable(words);
        }
        if (known.add(key) < 0) {
            keys.append(key);
        }
    }

    long size() {
        return keys.size();
    }

    Cursor all() {
        return keys.from(0);
    }

    LooseKeys moved(PackedLayout from, PackedLayout to) {
        LooseKeys moved = new LooseKeys(memory, to.words(), capacity);
        moved.keys = Moved.records(keys, memory, from, to, 0);
        moved.known = known.moved(from, to);
        return moved;
    }
}
