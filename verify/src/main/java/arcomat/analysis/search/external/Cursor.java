package arcomat.analysis.search.external;

/** Goes through records of some words each. */
interface Cursor {
    /** Goes on to the next record, the first one at first; whether there is one. */
    boolean next();

    /** A word of the record. */
    long word(int which);

    /** Copies the first words of the record, as many as there is room for. */
    default void copy(long[] into) {
        for (int word = 0; word < into.length; word++) {
            into[word] = word(word);
        }
    }

    /**
     * Compares the records of two cursors by their first words, the last of which counts most, as
     * numbers without a sign.
     */
    static int compare(Cursor one, Cursor other, int words) {
        for (int word = words - 1; word >= 0; word--) {
            int comparison = Long.compareUnsigned(one.word(word), other.word(word));
            if (comparison != 0) {
                return comparison;
            }
        }
        return 0;
    }
}
