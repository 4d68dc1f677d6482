package arcomat.pipeline.explored;

import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.external.ExternalPairs;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.analysis.search.packed.PairStore;
import arcomat.semantics.Promise;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;

/** What the searches for one answer explore, in a folder of their own. */
public final class ExploredSearches implements Closeable {
    private static final String GOES_ON =
            "what was explored is kept in '%s': the same command goes on from there";

    /** Bytes of heap for each word of a pair: in tables, and while they are sorted. */
    private static final long BYTES = 128;

    /** Words beside the key of a pair. */
    private static final int BESIDE = 3;

    private static final long MOST_PAIRS = 50_000_000;

    private final String written;
    private final Path folder;
    private final long heap;
    private final Map<String, BlockFolder> open = new HashMap<>();
    private final Map<Promise, Integer> asked = new HashMap<>();

    /**
     * @param written the folder that the user has named
     * @param folder that one, or one in it
     * @param heap how many bytes of it may be used; then files are
     */
    ExploredSearches(String written, Path folder, long heap) {
        this.written = written;
        this.folder = folder;
        this.heap = heap;
    }

    /**
     * Places for the pairs of the search whether a promise is kept. Whoever asks again goes on from
     * what was explored before.
     *
     * @param budget asked on the way
     */
    public PairStore.Maker stores(Promise promise, Budget budget) {
        int number = asked.computeIfAbsent(promise, fresh -> asked.size());
        int[] attempts = {0};
        return (network, layout) ->
                store(network, layout, number + "-" + attempts[0]++, budget::insist);
    }

    private PairStore store(
            PackedNetwork network, PackedLayout layout, String name, Runnable between) {
        try {
            BlockFolder memory = reopened(name);
            long capacity = heap / (BYTES * (layout.words() + BESIDE));
            return new ExternalPairs(
                    network, layout, memory, (int) Math.min(capacity, MOST_PAIRS), between);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Only one may be open in a folder: it removes what it has not written. */
    private BlockFolder reopened(String name) throws IOException {
        BlockFolder before = open.remove(name);
        if (before != null) {
            before.close();
        }
        BlockFolder memory = BlockFolder.in(folder.resolve(name));
        open.put(name, memory);
        return memory;
    }

    /** The verdict, with how to go on where it is unknown and there is something to go on with. */
    public Verdict told(Verdict verdict) {
        boolean used = open.values().stream().anyMatch(each -> each.notes().isPresent());
        return verdict.answer() == Answer.UNKNOWN && used
                ? verdict.with(GOES_ON.formatted(written))
                : verdict;
    }

    @Override
    public void close() throws IOException {
        for (BlockFolder each : open.values()) {
            each.close();
        }
    }
}
