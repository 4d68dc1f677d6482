package arcomat.analysis.refinement;

import arcomat.analysis.search.external.ExternalMemory;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/** An external memory that fails when it is told to, and then has what was committed. */
final class BlocksInMemory implements ExternalMemory {
    static final String KILLED = "killed";

    private final Map<Long, List<long[]>> volumes = new TreeMap<>();
    private Optional<long[]> notes = Optional.empty();
    private Map<Long, Long> committed = new TreeMap<>();
    private long names;
    private long patience = Long.MAX_VALUE;
    int commits;
    int written;

    /** Fails at the operation behind so many. */
    void failAfter(long operations) {
        patience = operations;
    }

    /** As another process finds it: what was written since may be there, in part. */
    BlocksInMemory afterwards() {
        BlocksInMemory next = new BlocksInMemory();
        next.volumes.putAll(volumes);
        next.notes = notes;
        next.committed = committed;
        next.names = names;
        return next;
    }

    private void work() {
        if (--patience < 0) {
            throw new UncheckedIOException(new IOException(KILLED));
        }
    }

    @Override
    public int blockWords() {
        return 16;
    }

    @Override
    public Volume create() {
        work();
        volumes.put(++names, new ArrayList<>());
        return new Blocks(names);
    }

    @Override
    public Volume open(long name, long blocks) {
        Long kept = committed.get(name);
        if (kept == null || kept != blocks) {
            throw new AssertionError(name + " was not committed with " + blocks + " blocks");
        }
        List<long[]> all = volumes.get(name);
        volumes.put(name, new ArrayList<>(all.subList(0, (int) blocks)));
        return new Blocks(name);
    }

    @Override
    public void commit(long[] fresh, List<Volume> kept) {
        work();
        commits++;
        notes = Optional.of(fresh.clone());
        committed = new TreeMap<>();
        kept.forEach(each -> committed.put(each.name(), each.blocks()));
        volumes.keySet().retainAll(committed.keySet());
    }

    @Override
    public Optional<long[]> notes() {
        return notes;
    }

    private final class Blocks implements Volume {
        private final long name;

        Blocks(long name) {
            this.name = name;
        }

        @Override
        public long name() {
            return name;
        }

        @Override
        public long blocks() {
            return volumes.get(name).size();
        }

        @Override
        public void append(long[] block) {
            work();
            written++;
            volumes.get(name).add(block.clone());
        }

        @Override
        public void read(long block, long[] into) {
            work();
            System.arraycopy(volumes.get(name).get((int) block), 0, into, 0, into.length);
        }
    }
}
