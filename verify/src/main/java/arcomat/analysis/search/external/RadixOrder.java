package arcomat.analysis.search.external;

/**
 * The order of records by their first words, the last of which counts most; what is equal keeps its
 * order. Digit by digit (radix sort: Knuth, "The Art of Computer Programming" 3, section 5.2.5).
 */
final class RadixOrder {
    private static final int BITS = 11;
    private static final int DIGITS = 1 << BITS;

    private int[] order;
    private int[] nextOrder;
    private long[] words;
    private long[] nextWords;

    private RadixOrder(int count) {
        order = new int[count];
        nextOrder = new int[count];
        words = new long[count];
        nextWords = new long[count];
        for (int i = 0; i < count; i++) {
            order[i] = i;
        }
    }

    /**
     * @param records one behind the other
     * @param width words of each
     * @param keyWords how many of them count
     */
    static int[] of(long[] records, int width, int keyWords, int count) {
        RadixOrder order = new RadixOrder(count);
        for (int word = 0; word < keyWords; word++) {
            order.sortBy(records, width, word);
        }
        return order.order;
    }

    private void sortBy(long[] records, int width, int word) {
        long different = 0;
        for (int i = 0; i < order.length; i++) {
            words[i] = records[order[i] * width + word];
            different |= words[i] ^ words[0];
        }
        for (int shift = 0; shift < Long.SIZE; shift += BITS) {
            if ((different >>> shift & DIGITS - 1) != 0) {
                distribute(shift);
            }
        }
    }

    private void distribute(int shift) {
        int[] places = new int[DIGITS + 1];
        for (long word : words) {
            places[(int) (word >>> shift & DIGITS - 1) + 1]++;
        }
        for (int digit = 1; digit <= DIGITS; digit++) {
            places[digit] += places[digit - 1];
        }
        for (int i = 0; i < order.length; i++) {
            int place = places[(int) (words[i] >>> shift & DIGITS - 1)]++;
            nextOrder[place] = order[i];
            nextWords[place] = words[i];
        }
        int[] sorted = nextOrder;
        nextOrder = order;
        order = sorted;
        long[] sortedWords = nextWords;
        nextWords = words;
        words = sortedWords;
    }
}
