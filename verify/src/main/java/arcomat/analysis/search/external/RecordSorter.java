package arcomat.analysis.search.external;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Sorts more records than fit into memory: runs that do fit are sorted and written, and merged when
 * they are read (Knuth, "The Art of Computer Programming" 3, section 5.4).
 */
final class RecordSorter {
    private static final int FEW = 256;

    private final ExternalMemory memory;
    private final int width;
    private final int keyWords;
    private final int capacity;
    private final List<Records> runs = new ArrayList<>();
    private long[] buffer;
    private int count;

    /**
     * @param width words of a record
     * @param keyWords the first of them, by which they are sorted
     * @param capacity so many records fit into memory
     */
    RecordSorter(ExternalMemory memory, int width, int keyWords, int capacity) {
        this.memory = memory;
        this.width = width;
        this.keyWords = keyWords;
        this.capacity = capacity;
        buffer = new long[FEW * width];
    }

    void add(long... record) {
        if (count == capacity) {
            spill();
        }
        if ((count + 1) * width > buffer.length) {
            buffer = Arrays.copyOf(buffer, buffer.length + (buffer.length >> 1) + width);
        }
        System.arraycopy(record, 0, buffer, count * width, width);
        count++;
    }

    /** Writes what is in memory. */
    void spill() {
        if (count == 0) {
            return;
        }
        Records run = new Records(memory, width, 0);
        long[] record = new long[width];
        for (Cursor sorted = fromMemory(); sorted.next(); ) {
            sorted.copy(record);
            run.append(record);
        }
        runs.add(run);
    }

    /** Goes through all of them; then there are none. */
    Cursor sorted() {
        if (runs.isEmpty()) {
            return fromMemory();
        }
        spill();
        List<Records> all = List.copyOf(runs);
        runs.clear();
        return Merge.of(all, keyWords);
    }

    /** Those that were written. */
    List<Records> runs() {
        return runs;
    }

    private Cursor fromMemory() {
        long[] records = buffer;
        int[] order = RadixOrder.of(records, width, keyWords, count);
        buffer = new long[FEW * width];
        count = 0;
        return new Cursor() {
            private int position = -1;

            @Override
            public boolean next() {
                return ++position < order.length;
            }

            @Override
            public long word(int which) {
                return records[order[position] * width + which];
            }
        };
    }
}
