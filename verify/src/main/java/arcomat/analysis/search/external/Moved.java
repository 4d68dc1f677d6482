package arcomat.analysis.search.external;

import arcomat.analysis.search.packed.PackedLayout;

/**
 * Records that begin with a key, in another layout. The last field of a key counts most, in any
 * layout: what was sorted is sorted afterwards.
 */
final class Moved {
    private Moved() {}

    /**
     * @param indexed as of {@link Records}
     */
    static Records records(
            Records records,
            ExternalMemory memory,
            PackedLayout from,
            PackedLayout to,
            int indexed) {
        int behind = records.width - from.words();
        Records moved = new Records(memory, to.words() + behind, indexed);
        long[] old = new long[from.words()];
        for (Cursor each = records.from(0); each.next(); ) {
            each.copy(old);
            long[] record = new long[moved.width];
            from.move(old, to, record);
            for (int word = 0; word < behind; word++) {
                record[to.words() + word] = each.word(old.length + word);
            }
            moved.append(record);
        }
        return moved;
    }
}
