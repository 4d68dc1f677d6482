package arcomat.analysis.search.external;

import arcomat.analysis.search.external.ExternalMemory.Volume;

import com.carrotsearch.hppc.LongArrayList;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * Records of some words each, one behind the other. The last block, which is not full, is here; the
 * others are in a volume, which few blocks do without.
 */
final class Records {
    /** Blocks that are kept here before there is a volume. */
    private static final int FEW = 16;

    final int width;
    private final ExternalMemory memory;
    private final int perBlock;
    private final int blockWords;
    private long[] last;
    private List<long[]> first = new ArrayList<>();
    private @Nullable Volume volume;
    private long size;

    /** The first record of each block, where they are in an order. */
    private final LongArrayList index = new LongArrayList();

    private final int indexed;

    /**
     * @param indexed the first words of a record by which they will be in an order; 0 where they
     *     are in none
     */
    Records(ExternalMemory memory, int width, int indexed) {
        this.memory = memory;
        this.width = width;
        this.indexed = indexed;
        blockWords = memory.blockWords();
        perBlock = blockWords / width;
        last = new long[blockWords];
    }

    /** As they were {@link #note noted}. */
    static Records noted(Notes notes, ExternalMemory memory, int width, int indexed) {
        Records records = new Records(memory, width, indexed);
        records.size = notes.next();
        long name = notes.next();
        long blocks = records.size / records.perBlock;
        if (blocks > 0) {
            records.volume = memory.open(name, blocks);
        }
        int rest = (int) (records.size % records.perBlock) * width;
        for (int word = 0; word < rest; word++) {
            records.last[word] = notes.next();
        }
        records.indexAll();
        return records;
    }

    private void indexAll() {
        long[] block = block();
        for (long i = 0; indexed > 0 && i * perBlock < size; i++) {
            read(i, block);
            for (int word = 0; word < indexed; word++) {
                index.add(block[word]);
            }
        }
    }

    /** Writes down where they are; full blocks are in a volume afterwards. */
    void note(Notes notes, List<Volume> kept) {
        if (size >= perBlock) {
            kept.add(volume());
        }
        notes.add(size);
        notes.add(size < perBlock ? 0 : volume().name());
        int rest = (int) (size % perBlock) * width;
        for (int word = 0; word < rest; word++) {
            notes.add(last[word]);
        }
    }

    private Volume volume() {
        if (volume == null) {
            volume = memory.create();
            first.forEach(volume::append);
            first = List.of();
        }
        return volume;
    }

    long size() {
        return size;
    }

    void append(long... record) {
        int place = (int) (size % perBlock);
        if (place == 0) {
            for (int word = 0; word < indexed; word++) {
                index.add(record[word]);
            }
        }
        System.arraycopy(record, 0, last, place * width, width);
        size++;
        if (place + 1 == perBlock) {
            finish();
        }
    }

    private void finish() {
        if (volume == null && first.size() < FEW) {
            first.add(last);
            last = new long[blockWords];
        } else {
            volume().append(last);
        }
    }

    /** Of each block but the last one. */
    int perBlock() {
        return perBlock;
    }

    /** An array that a block can be read into. */
    long[] block() {
        return new long[blockWords];
    }

    int inBlock(long block) {
        return (int) Math.min(perBlock, size - block * perBlock);
    }

    void read(long block, long[] into) {
        if (block == size / perBlock) {
            System.arraycopy(last, 0, into, 0, into.length);
        } else if (volume == null) {
            System.arraycopy(first.get((int) block), 0, into, 0, into.length);
        } else {
            volume.read(block, into);
        }
    }

    /** Compares a key with the first record of a block, as {@link Cursor#compare} does. */
    int compareToFirst(long[] key, int block) {
        for (int word = indexed - 1; word >= 0; word--) {
            int comparison = Long.compareUnsigned(key[word], index.get(block * indexed + word));
            if (comparison != 0) {
                return comparison;
            }
        }
        return 0;
    }

    /** How many blocks there are, the last one included. */
    int blocks() {
        return (int) ((size + perBlock - 1) / perBlock);
    }

    Cursor from(long number) {
        return new Walk(number);
    }

    /** Reads them one after the other, as many as there are when it gets there. */
    private final class Walk implements Cursor {
        private final long[] block = block();
        private long position;
        private long loaded = -1;
        private int start;

        Walk(long number) {
            position = number - 1;
        }

        @Override
        public boolean next() {
            position++;
            if (position >= size) {
                return false;
            }
            if (position / perBlock != loaded) {
                loaded = position / perBlock;
                read(loaded, block);
            }
            start = (int) (position % perBlock) * width;
            return true;
        }

        @Override
        public long word(int which) {
            return block[start + which];
        }
    }
}
