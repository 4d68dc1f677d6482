package arcomat.analysis.search.external;

import arcomat.analysis.search.external.ExternalMemory.Volume;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedTable;

import java.util.ArrayList;
import java.util.List;

/** The keys that have been met: young ones in a table, the others in sorted runs. */
final class VisitedKeys {
    /** More are merged, since each of them is looked at for each level. */
    private static final int MOST_RUNS = 16;

    private final ExternalMemory memory;
    private final int words;
    private final int capacity;
    private final Runnable between;
    private final List<Records> runs = new ArrayList<>();
    private PackedTable young;

    /**
     * @param capacity so many keys may be young
     * @param between called before what may take long; may throw to give up
     */
    VisitedKeys(ExternalMemory memory, int words, int capacity, Runnable between) {
        this.memory = memory;
        this.words = words;
        this.capacity = capacity;
        this.between = between;
        young = new PackedTable(words);
    }

    /** Takes those that are not young as they were {@link #note noted}. */
    void noted(Notes notes) {
        for (long count = notes.next(); count > 0; count--) {
            runs.add(Records.noted(notes, memory, words, words));
        }
    }

    /** Writes down where those are that are not young. */
    void note(Notes notes, List<Volume> kept) {
        notes.add(runs.size());
        runs.forEach(run -> run.note(notes, kept));
    }

    boolean isYoung(long[] key) {
        return young.find(key) >= 0;
    }

    /** For each run, whether keys are in it. */
    List<RunLookup> lookups() {
        return runs.stream().map(RunLookup::new).toList();
    }

    void addYoung(long[] key) {
        young.add(key);
    }

    boolean isFull() {
        return young.size() >= capacity;
    }

    /** Makes a run of those that are young. */
    void age() {
        if (young.size() == 0) {
            return;
        }
        RecordSorter sorter = new RecordSorter(memory, words, words, young.size());
        long[] key = new long[words];
        for (int i = 0; i < young.size(); i++) {
            young.get(i, key);
            sorter.add(key);
        }
        young = new PackedTable(words);
        Records run = run();
        copy(sorter.sorted(), run);
        add(run);
    }

    /** A run to be filled, and added. */
    Records run() {
        return new Records(memory, words, words);
    }

    /** Adds a sorted run; runs that are not larger than the next one are merged. */
    void add(Records run) {
        runs.add(run);
        for (int last = runs.size() - 1; last > 0 && isToBeMerged(last); last--) {
            Records merged = run();
            copy(Merge.of(runs.subList(last - 1, last + 1), words), merged);
            runs.subList(last - 1, last + 1).clear();
            runs.add(merged);
        }
    }

    private boolean isToBeMerged(int last) {
        return runs.get(last - 1).size() <= runs.get(last).size() || last >= MOST_RUNS;
    }

    private void copy(Cursor from, Records to) {
        long[] key = new long[words];
        while (from.next()) {
            from.copy(key);
            to.append(key);
            between.run();
        }
    }

    /** The same keys in another layout. */
    VisitedKeys moved(PackedLayout from, PackedLayout to) {
        VisitedKeys moved = new VisitedKeys(memory, to.words(), capacity, between);
        runs.forEach(run -> moved.runs.add(Moved.records(run, memory, from, to, to.words())));
        moved.young = young.moved(from, to);
        return moved;
    }
}
