package arcomat.analysis.search.external;

import com.carrotsearch.hppc.LongArrayList;

import java.util.Arrays;

/** Numbers that are written one after the other, and read in the same order. */
final class Notes {
    private final LongArrayList words;
    private int read;

    Notes(long... words) {
        this.words = LongArrayList.from(words);
    }

    void add(long word) {
        words.add(word);
    }

    /** Some words, with how many there are. */
    void addAll(int... some) {
        add(some.length);
        for (int word : some) {
            add(word);
        }
    }

    int[] nextAll() {
        int[] some = new int[(int) next()];
        Arrays.setAll(some, word -> (int) next());
        return some;
    }

    long next() {
        return words.get(read++);
    }

    long[] all() {
        return words.toArray();
    }
}
