package arcomat.analysis.search.packed;

import com.carrotsearch.hppc.IntArrayList;

/** The events that wait for a part, by number: a ring that grows up to its capacity. */
final class EventQueue {
    private static final int FEW = 4;

    private final int capacity;
    private int[] ring = new int[FEW];
    private int first;
    private int size;

    EventQueue(int capacity) {
        this.capacity = capacity;
    }

    boolean isEmpty() {
        return size == 0;
    }

    boolean isFull() {
        return size >= capacity;
    }

    void clear() {
        size = 0;
    }

    void add(int event) {
        if (size == ring.length) {
            grow();
        }
        ring[first + size & ring.length - 1] = event;
        size++;
    }

    private void grow() {
        int[] longer = new int[2 * ring.length];
        for (int i = 0; i < size; i++) {
            longer[i] = ring[first + i & ring.length - 1];
        }
        ring = longer;
        first = 0;
    }

    /** The one that is taken next. */
    int first() {
        return ring[first];
    }

    void remove() {
        first = first + 1 & ring.length - 1;
        size--;
    }

    /** Writes it down. */
    void save(IntArrayList into) {
        into.add(size);
        for (int i = 0; i < size; i++) {
            into.add(ring[first + i & ring.length - 1]);
        }
    }

    /**
     * Becomes what was written down.
     *
     * @return where that ends
     */
    int restore(int[] from, int position) {
        size = from[position];
        first = 0;
        while (ring.length < size) {
            ring = new int[2 * ring.length];
        }
        System.arraycopy(from, position + 1, ring, 0, size);
        return position + 1 + size;
    }
}
