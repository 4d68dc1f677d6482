package arcomat.analysis.search.external;

/** Goes through sorted candidates; of those with one key, what they say together. */
final class DistinctCandidates {
    private final Cursor sorted;
    private final int words;
    private final long[] key;
    private boolean more;
    private long came;
    private long way;

    DistinctCandidates(Cursor sorted, int words) {
        this.sorted = sorted;
        this.words = words;
        key = new long[words];
        more = sorted.next();
    }

    boolean next() {
        if (!more) {
            return false;
        }
        sorted.copy(key);
        came = sorted.word(words);
        way = sorted.word(words + 1);
        for (more = sorted.next(); more && isSame(); more = sorted.next()) {
            long other = sorted.word(words + 1);
            if (Candidates.cost(other) < Candidates.cost(way)) {
                way = other;
            }
        }
        return true;
    }

    private boolean isSame() {
        for (int word = 0; word < words; word++) {
            if (key[word] != sorted.word(word)) {
                return false;
            }
        }
        return true;
    }

    long[] key() {
        return key;
    }

    /** When it came first. */
    long came() {
        return came;
    }

    int parent() {
        return Candidates.parent(way);
    }

    int cost() {
        return Candidates.cost(way);
    }
}
