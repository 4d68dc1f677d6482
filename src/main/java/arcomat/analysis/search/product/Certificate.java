package arcomat.analysis.search.product;

import java.util.List;

/**
 * Why every trace of the left side is one of the right side: an inductive invariant of both.
 *
 * @param form how it is told
 */
public record Certificate(Form form, List<Entry> entries) {
    /** How an invariant is told. */
    public enum Form {
        /**
         * Pairs of a configuration of the left and a set of configurations of the right, such that
         * every step out of a pair leads to a pair again, or to chaos of the right side. A set of
         * one is simulation, larger ones are what inclusion needs beyond it.
         */
        PAIRS,

        /**
         * Pairs of a state of the left and one of the right, each with conditions over variables of
         * both, such that every step out of what they allow is answered by one that leads to what
         * they allow.
         */
        CONDITIONS
    }

    public Certificate {
        entries = List.copyOf(entries);
    }

    /** Of pairs of configurations. */
    public Certificate(List<Entry> entries) {
        this(Form.PAIRS, entries);
    }

    /**
     * A pair.
     *
     * @param left name of the configuration; of conditions, the names of both states
     * @param right names of configurations, or conditions
     */
    public record Entry(String left, List<String> right) {
        public Entry {
            right = List.copyOf(right);
        }
    }
}
