package arcomat.analysis.search.external;

import arcomat.analysis.search.external.ExternalMemory.Volume;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedTable;

import com.carrotsearch.hppc.IntArrayList;

import java.util.List;

/**
 * What the pairs of a level lead to: keys, each with when it came first, and the first of the
 * cheapest ways to it. Some are met again, and some come more than once; those of one run do not.
 */
final class Candidates {
    private static final int BATCH = PackedTable.MOST_TOUCHED;
    private static final long LOW = 0xFFFF_FFFFL;

    private final ExternalMemory memory;
    private final int words;
    private final int capacity;
    private final RecordSorter sorter;
    private PackedTable table;
    private IntArrayList parents = new IntArrayList();
    private IntArrayList costs = new IntArrayList();

    /** Of many at once, the table finds the places sooner. */
    private final long[] waitingKeys;

    private final int[] parentsOfWaiting = new int[BATCH];
    private final int[] costsOfWaiting = new int[BATCH];
    private int waiting;

    /** How many have come, but for those in the table. */
    private long came;

    Candidates(ExternalMemory memory, int words, int capacity) {
        this.memory = memory;
        this.words = words;
        this.capacity = capacity;
        table = new PackedTable(words);
        waitingKeys = new long[BATCH * words];
        sorter = new RecordSorter(memory, words + 2, words, capacity + BATCH);
    }

    /** As they were {@link #note noted}. */
    static Candidates noted(Notes notes, ExternalMemory memory, int words, int capacity) {
        Candidates candidates = new Candidates(memory, words, capacity);
        candidates.came = notes.next();
        for (long runs = notes.next(); runs > 0; runs--) {
            candidates.sorter.runs().add(Records.noted(notes, memory, words + 2, 0));
        }
        return candidates;
    }

    /** Writes down where they are; none is in memory only afterwards. */
    void note(Notes notes, List<Volume> kept) {
        spill();
        notes.add(came);
        notes.add(sorter.runs().size());
        sorter.runs().forEach(run -> run.note(notes, kept));
    }

    void add(long[] key, int parent, int cost) {
        if (waiting == BATCH) {
            addWaiting();
        }
        System.arraycopy(key, 0, waitingKeys, waiting * words, words);
        parentsOfWaiting[waiting] = parent;
        costsOfWaiting[waiting++] = cost;
    }

    private void addWaiting() {
        table.touch(waitingKeys, waiting);
        for (int i = 0; i < waiting; i++) {
            int number = table.add(waitingKeys, i * words);
            if (number < 0) {
                parents.add(parentsOfWaiting[i]);
                costs.add(costsOfWaiting[i]);
            } else if (costsOfWaiting[i] < costs.get(number)) {
                parents.set(number, parentsOfWaiting[i]);
                costs.set(number, costsOfWaiting[i]);
            }
        }
        waiting = 0;
    }

    /** Whether they should be spilled. */
    boolean isFull() {
        return table.size() >= capacity;
    }

    /** Whether some are not in memory. */
    boolean haveSpilled() {
        return !sorter.runs().isEmpty();
    }

    /** There are no more than so many different ones. */
    long most() {
        addWaiting();
        return sorter.runs().stream().mapToLong(Records::size).sum() + table.size();
    }

    /** Writes those in memory as a run. */
    void spill() {
        drain();
        sorter.spill();
    }

    /** Goes through them in the order of their keys; then there are none. */
    Cursor sorted() {
        drain();
        came = 0;
        return sorter.sorted();
    }

    private void drain() {
        addWaiting();
        long[] record = new long[words + 2];
        for (int i = 0; i < table.size(); i++) {
            table.get(i, record);
            record[words] = came + i;
            record[words + 1] = (long) parents.get(i) << Integer.SIZE | costs.get(i);
            sorter.add(record);
        }
        came += table.size();
        table = new PackedTable(words);
        parents = new IntArrayList();
        costs = new IntArrayList();
    }

    static int parent(long way) {
        return (int) (way >> Integer.SIZE);
    }

    static int cost(long way) {
        return (int) (way & LOW);
    }

    /** The same in another layout, in which their keys have the same order. */
    Candidates moved(PackedLayout from, PackedLayout to) {
        addWaiting();
        Candidates moved = new Candidates(memory, to.words(), capacity);
        moved.came = came;
        for (Records run : sorter.runs()) {
            moved.sorter.runs().add(Moved.records(run, memory, from, to, 0));
        }
        moved.table = table.moved(from, to);
        moved.parents = parents;
        moved.costs = costs;
        return moved;
    }
}
