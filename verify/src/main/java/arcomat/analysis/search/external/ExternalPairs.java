package arcomat.analysis.search.external;

import arcomat.analysis.search.external.ExternalMemory.Volume;
import arcomat.analysis.search.packed.CheapestFailure;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.analysis.search.packed.PackedNetwork.TooNarrow;
import arcomat.analysis.search.packed.PairStore;
import arcomat.semantics.value.GivenUp;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Pairs in a memory beyond the heap: the same levels, each in the same order, as if all were in
 * memory. What a level leads to is sorted at its end, and what has been met before is left out.
 *
 * <p>What has been found so far is committed now and then, and at the end: a search that is begun
 * again goes on behind the last pair whose steps have been committed. The numbers in keys are given
 * as they come; so each pair that brought new ones is kept besides, and expanded again first.
 */
public final class ExternalPairs implements PairStore {
    private static final long LOW = 0xFFFF_FFFFL;

    private final PackedNetwork network;
    private final ExternalMemory memory;
    private final int capacity;
    private final Runnable between;
    private PackedLayout layout;
    private boolean replaying;

    /** The pairs, level by level: the key, then how far before it its parent is, and its cost. */
    private Records pairs;

    private VisitedKeys visited;

    /** How many of the pairs are in runs of visited keys; the others are young. */
    private long aged;

    private Candidates candidates;
    private LooseKeys loose;
    private Lessons lessons = new Lessons();

    private long levelStart;
    private long levelEnd;

    /** Pairs before that one need not be looked at any more. */
    private long expanded;

    /** Whether the next pair is being expanded. */
    private boolean handed;

    private @Nullable Cursor walk;
    private long[] current;
    private int currentCost;
    private CheapestFailure failure = new CheapestFailure();

    /**
     * Whether what is here could not be gone on with: beginnings are missing, or a level has been
     * given up between its end and the beginning of the next one.
     */
    private boolean torn = true;

    /**
     * @param memory what was committed in it is gone on with
     * @param capacity so many pairs fit into memory
     * @param between called before what may take long; may throw to give up
     */
    public ExternalPairs(
            PackedNetwork network,
            PackedLayout layout,
            ExternalMemory memory,
            int capacity,
            Runnable between) {
        this.network = network;
        this.layout = layout;
        this.memory = memory;
        this.capacity = capacity;
        this.between = between;
        replaying = memory.notes().isPresent();
        int words = layout.words();
        pairs = new Records(memory, words + 1, 0);
        visited = new VisitedKeys(memory, words, capacity / 2, between);
        candidates = new Candidates(memory, words, capacity);
        loose = new LooseKeys(memory, words, capacity / 2);
        current = new long[words];
    }

    @Override
    public void move(PackedLayout to) {
        if (replaying || layout.hasWidthsOf(to)) {
            layout = to;
            return;
        }
        pairs = Moved.records(pairs, memory, layout, to, 0);
        visited = visited.moved(layout, to);
        candidates = candidates.moved(layout, to);
        loose = loose.moved(layout, to);
        long[] moved = new long[to.words()];
        layout.move(current, to, moved);
        current = moved;
        layout = to;
        walk = null;
    }

    @Override
    public long size() {
        return levelEnd;
    }

    @Override
    public void add(long[] key, int parent, int set, int cost) {
        if (!layout.fits(network.markField(), set)) {
            throw new TooNarrow();
        }
        if (!replaying) {
            layout.put(key, network.markField(), set);
            candidates.add(key, parent, cost);
        }
    }

    @Override
    public void addLoose(long[] key) {
        if (!replaying) {
            loose.add(key);
        }
    }

    @Override
    public void fail(int parent, int cost) {
        if (!replaying) {
            failure.add(levelStart + parent, cost);
        }
    }

    @Override
    public CheapestFailure failure() {
        return failure;
    }

    @Override
    public boolean next() {
        torn = false;
        if (handed) {
            expanded++;
            handed = false;
        }
        if (candidates.isFull()) {
            candidates.spill();
            commit();
        }
        if (expanded == levelEnd) {
            return false;
        }
        if (walk == null) {
            walk = pairs.from(expanded);
        }
        Cursor pair = walk;
        pair.next();
        pair.copy(current);
        currentCost = (int) (pair.word(current.length) & LOW);
        handed = true;
        return true;
    }

    @Override
    public int node() {
        return replaying ? 0 : (int) (expanded - levelStart);
    }

    @Override
    public int cost() {
        return currentCost;
    }

    @Override
    public void get(long[] into) {
        if (replaying) {
            lessons.pack(layout, into);
        } else {
            System.arraycopy(current, 0, into, 0, current.length);
        }
    }

    @Override
    public void learn() {
        if (!replaying) {
            lessons.add(layout, current);
        }
    }

    @Override
    public boolean nextLevel() {
        if (candidates.haveSpilled()) {
            candidates.spill();
            commit();
        }
        torn = true;
        boolean many = candidates.most() > capacity / 4;
        if (many) {
            visited.age();
        }
        append(fresh(many ? visited.run() : null), !many);
        if (many || visited.isFull()) {
            visited.age();
            aged = pairs.size();
        }
        torn = false;
        if (aged == pairs.size()) {
            commit();
        }
        return levelStart < levelEnd;
    }

    /**
     * The candidates that have not been met, in the order of their cost and as they came.
     *
     * @param run filled with their keys, and added to those of visited keys
     */
    private Cursor fresh(@Nullable Records run) {
        int words = layout.words();
        RecordSorter sorter = new RecordSorter(memory, words + 3, 2, capacity / 2 + 1);
        List<RunLookup> older = visited.lookups();
        DistinctCandidates found = new DistinctCandidates(candidates.sorted(), words);
        long[] record = new long[words + 3];
        while (found.next()) {
            between.run();
            if (isVisited(found.key(), older)) {
                continue;
            }
            record[0] = found.came();
            record[1] = found.cost();
            record[2] = found.parent();
            System.arraycopy(found.key(), 0, record, 3, words);
            sorter.add(record);
            if (run != null) {
                run.append(found.key());
            }
        }
        if (run != null) {
            visited.add(run);
        }
        return sorter.sorted();
    }

    private boolean isVisited(long[] key, List<RunLookup> older) {
        if (visited.isYoung(key)) {
            return true;
        }
        for (RunLookup each : older) {
            if (each.contains(key)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Makes a level of them.
     *
     * @param young whether they are in no run yet
     */
    private void append(Cursor fresh, boolean young) {
        int words = layout.words();
        long[] record = new long[words + 1];
        while (fresh.next()) {
            between.run();
            for (int word = 0; word < words; word++) {
                record[word] = fresh.word(3 + word);
            }
            if (young) {
                visited.addYoung(record);
            }
            long parent = fresh.word(2);
            long distance = parent == NONE ? 0 : pairs.size() - levelStart - parent;
            record[words] = distance << Integer.SIZE | fresh.word(1);
            pairs.append(record);
        }
        levelStart = levelEnd;
        levelEnd = pairs.size();
        expanded = failure.isFound() ? levelEnd : levelStart;
        walk = null;
    }

    @Override
    public void close() {
        if (torn) {
            return;
        }
        if (failure.isFound() && expanded == levelEnd) {
            try {
                nextLevel();
            } catch (GivenUp uncounted) {
                return;
            }
        }
        commit();
    }

    private void commit() {
        Notes notes = new Notes();
        List<Volume> kept = new ArrayList<>();
        lessons.note(notes);
        int[] met = network.met();
        notes.addAll(met);
        notes.add(network.digest(met));
        notes.addAll(IntStream.range(0, layout.fields()).map(layout::width).toArray());
        for (long each : new long[] {levelStart, levelEnd, expanded, aged}) {
            notes.add(each);
        }
        notes.add(failure.pair());
        notes.add(failure.cost());
        pairs.note(notes, kept);
        visited.note(notes, kept);
        candidates.note(notes, kept);
        loose.note(notes, kept);
        memory.commit(notes.all(), kept);
    }

    @Override
    public @Nullable PackedLayout resume(Runnable expand) {
        if (!replaying) {
            return null;
        }
        Notes notes = new Notes(memory.notes().orElseThrow());
        lessons = Lessons.noted(notes);
        while (lessons.next()) {
            expand.run();
        }
        int[] met = notes.nextAll();
        if (!isAtLeast(network.met(), met) || network.digest(met) != notes.next()) {
            throw new UncheckedIOException(new IOException("it was written by another search"));
        }
        layout = PackedLayout.of(notes.nextAll());
        restore(notes);
        replaying = false;
        return layout;
    }

    private static boolean isAtLeast(int[] counts, int[] others) {
        return counts.length == others.length
                && IntStream.range(0, counts.length).allMatch(i -> counts[i] >= others[i]);
    }

    private void restore(Notes notes) {
        int words = layout.words();
        levelStart = notes.next();
        levelEnd = notes.next();
        expanded = notes.next();
        aged = notes.next();
        failure = new CheapestFailure(notes.next(), (int) notes.next());
        pairs = Records.noted(notes, memory, words + 1, 0);
        visited = new VisitedKeys(memory, words, capacity / 2, between);
        visited.noted(notes);
        candidates = Candidates.noted(notes, memory, words, capacity);
        loose = LooseKeys.noted(notes, memory, words, capacity / 2);
        current = new long[words];
        for (Cursor young = pairs.from(aged); young.next(); ) {
            visited.addYoung(key(young));
        }
    }

    private long[] key(Cursor pair) {
        long[] key = new long[layout.words()];
        pair.copy(key);
        return key;
    }

    @Override
    public List<long[]> path() {
        List<long[]> path = new ArrayList<>();
        long distance = 1;
        for (long pair = failure.pair(); pair != NONE && distance > 0; pair -= distance) {
            Cursor at = pairs.from(pair);
            at.next();
            path.add(key(at));
            distance = at.word(layout.words()) >>> Integer.SIZE;
        }
        Collections.reverse(path);
        return path;
    }

    @Override
    public int configurations(int sets) {
        if (sets <= 1 && loose.size() == 0) {
            return (int) levelEnd;
        }
        int words = layout.words();
        RecordSorter sorter = new RecordSorter(memory, words, words, capacity);
        for (Cursor pair = pairs.from(0); pair.next(); ) {
            between.run();
            long[] key = key(pair);
            layout.clear(key, network.markField());
            sorter.add(key);
        }
        for (Cursor key = loose.all(); key.next(); ) {
            between.run();
            sorter.add(key(key));
        }
        return distinct(sorter.sorted());
    }

    private int distinct(Cursor sorted) {
        int count = 0;
        long[] last = new long[0];
        while (sorted.next()) {
            between.run();
            long[] key = key(sorted);
            if (!Arrays.equals(key, last)) {
                count++;
            }
            last = key;
        }
        return count;
    }
}
