package arcomat.analysis.search.product;

import java.util.List;

/**
 * Why every trace of the left side is one of the right side: pairs of a configuration of the left
 * and a set of configurations of the right, such that every step out of a pair leads to a pair
 * again, or to chaos of the right side. A set of one is simulation, larger ones are what inclusion
 * needs beyond it.
 */
public record Certificate(List<Entry> entries) {
    public Certificate {
        entries = List.copyOf(entries);
    }

    /** A pair, by the names of its configurations. */
    public record Entry(String left, List<String> right) {
        public Entry {
            right = List.copyOf(right);
        }
    }
}
