package arcomat.analysis.search.packed;

import arcomat.semantics.value.GivenUp;

import java.util.Arrays;

/**
 * Keys of some words each, numbered from 0 in the order in which they come. They lie one behind the
 * other; where they are is found by open addressing with linear probing (Knuth, "The Art of
 * Computer Programming" 3, section 6.4), of four bytes a place.
 */
public final class PackedTable {
    private static final int CHUNK_BITS = 12;
    private static final int CHUNK = 1 << CHUNK_BITS;
    private static final int FEW = 64;

    /** So many leave places free in the longest table whose length is a power of two. */
    private static final int MOST = 700_000_000;

    /** The most keys that are touched at once. */
    public static final int MOST_TOUCHED = 256;

    private static final long GOLDEN = 0x9E3779B97F4A7C15L;

    private final int words;
    private long[][] chunks = new long[1][];
    private int size;

    /** What has been read by {@link #touch}: without it, nothing would be. */
    private final int[] touched = new int[MOST_TOUCHED];

    /**
     * Numbers plus one, in as many bits as it takes to count the places; the other bits are of the
     * key's hash, so that few keys are compared that differ. 0 where there is none.
     */
    private int[] places = new int[FEW];

    /**
     * @param words of each key
     */
    public PackedTable(int words) {
        this.words = words;
        chunks[0] = new long[words << CHUNK_BITS];
    }

    public int size() {
        return size;
    }

    /** The number of a key; -1 if it is not there. */
    public int find(long[] key) {
        return number(places[place(key, 0)]);
    }

    /**
     * Adds a key that may be there.
     *
     * @return its number, if it is there; else the bits of its new number turned round, which is
     *     negative
     */
    public int add(long[] key) {
        return add(key, 0);
    }

    private int number(int place) {
        return (place & places.length - 1) - 1;
    }

    /** As above, of the key that begins at a position. */
    public int add(long[] keys, int start) {
        int place = place(keys, start);
        if (places[place] != 0) {
            return number(places[place]);
        }
        append(keys, start);
        int mask = places.length - 1;
        places[place] = (int) hash(keys, start) & ~mask | size;
        if (size > places.length / 3 * 2) {
            grow();
        }
        return ~(size - 1);
    }

    /**
     * Reads all that {@link #add} is going to read for some keys: one after the other they would
     * wait for memory each, and like this they wait together.
     *
     * @param keys one behind the other
     */
    public void touch(long[] keys, int count) {
        int mask = places.length - 1;
        for (int i = 0; i < count; i++) {
            touched[i] = places[(int) (hash(keys, i * words) >>> 32) & mask];
        }
        for (int i = 0; i < count; i++) {
            int number = Math.max(0, (touched[i] & mask) - 1);
            touched[i] = (int) chunks[number >>> CHUNK_BITS][(number & CHUNK - 1) * words];
        }
    }

    private void append(long[] keys, int start) {
        if (size == MOST) {
            throw new GivenUp("more than " + MOST + " packed configurations");
        }
        int chunk = size >>> CHUNK_BITS;
        if (chunk == chunks.length) {
            chunks = Arrays.copyOf(chunks, 2 * chunk);
        }
        if (chunks[chunk] == null) {
            chunks[chunk] = new long[words << CHUNK_BITS];
        }
        System.arraycopy(keys, start, chunks[chunk], (size & CHUNK - 1) * words, words);
        size++;
    }

    /** Writes a key down. */
    public void get(int number, long[] into) {
        int from = (number & CHUNK - 1) * words;
        System.arraycopy(chunks[number >>> CHUNK_BITS], from, into, 0, words);
    }

    /** Where a key is, or would be. */
    private int place(long[] keys, int start) {
        int mask = places.length - 1;
        long hash = hash(keys, start);
        int tag = (int) hash & ~mask;
        int place = (int) (hash >>> 32) & mask;
        while (places[place] != 0) {
            boolean alike = (places[place] & ~mask) == tag;
            if (alike && isAt((places[place] & mask) - 1, keys, start)) {
                return place;
            }
            place = place + 1 & mask;
        }
        return place;
    }

    private boolean isAt(int number, long[] keys, int start) {
        long[] chunk = chunks[number >>> CHUNK_BITS];
        int from = (number & CHUNK - 1) * words;
        for (int i = 0; i < words; i++) {
            if (chunk[from + i] != keys[start + i]) {
                return false;
            }
        }
        return true;
    }

    private long hash(long[] from, int start) {
        long hash = 0;
        for (int i = 0; i < words; i++) {
            hash = (hash ^ from[start + i]) * GOLDEN;
            hash ^= hash >>> 32;
        }
        hash *= GOLDEN;
        return hash ^ hash >>> 32;
    }

    /** The old places are given up before there are new ones. */
    private void grow() {
        int length = 2 * places.length;
        places = new int[0];
        places = new int[length];
        int mask = length - 1;
        for (int number = 0; number < size; number++) {
            long[] chunk = chunks[number >>> CHUNK_BITS];
            long hash = hash(chunk, (number & CHUNK - 1) * words);
            int place = (int) (hash >>> 32) & mask;
            while (places[place] != 0) {
                place = place + 1 & mask;
            }
            places[place] = (int) hash & ~mask | number + 1;
        }
    }

    /** The same keys with the same numbers in another layout. */
    public PackedTable moved(PackedLayout from, PackedLayout to) {
        PackedTable table = new PackedTable(to.words());
        long[] old = new long[words];
        for (int number = 0; number < size; number++) {
            long[] moved = new long[to.words()];
            get(number, old);
            from.move(old, to, moved);
            table.add(moved);
        }
        return table;
    }
}
