package arcomat.analysis.search.external;

import java.util.List;
import java.util.Optional;

/**
 * Where blocks of words are kept that do not fit into memory, and stay when the process ends. What
 * cannot be written or read ends the search, as {@link java.io.UncheckedIOException}.
 */
public interface ExternalMemory {
    /** Blocks that are written one behind the other, and read in any order. */
    interface Volume {
        /** By which it is found again. */
        long name();

        long blocks();

        /** Writes one more block. */
        void append(long[] block);

        /** Reads a block as it was written, or fails. */
        void read(long block, long[] into);
    }

    /** Words of a block: enough for any record. */
    int blockWords();

    /** An empty volume; nobody finds it later before it is committed. */
    Volume create();

    /** A volume that was committed, as it was then: blocks that came later are cut off. */
    Volume open(long name, long blocks);

    /**
     * From now on, this is what is found later, even if the process ends at once: these notes, and
     * these volumes with the blocks that they have now. All other volumes are given up.
     */
    void commit(long[] notes, List<Volume> kept);

    /** What was committed last, by whichever process; empty where nothing was. */
    Optional<long[]> notes();
}
