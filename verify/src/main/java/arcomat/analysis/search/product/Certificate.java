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
        CONDITIONS,

        /**
         * What is never so all at once, of parts of the left side, of what they have sent, and of
         * what the right side may be in: no run begins there, and no step leads there from
         * elsewhere, or is forbidden.
         */
        CLAUSES
    }

    /** What stands before what is never so. */
    public static final String NEVER = "never";

    public Certificate {
        entries = List.copyOf(entries);
    }

    /** Of pairs of configurations. */
    public Certificate(List<Entry> entries) {
        this(Form.PAIRS, entries);
    }

    /** Of what is never so all at once. */
    public static Certificate ofClauses(List<List<String>> never) {
        return new Certificate(
                Form.CLAUSES, never.stream().map(each -> new Entry(NEVER, each)).toList());
    }

    /**
     * A pair, or a clause.
     *
     * @param left name of the configuration; of conditions, the names of both states; of clauses
     *     {@link #NEVER}
     * @param right names of configurations, or conditions, or what is so
     */
    public record Entry(String left, List<String> right) {
        public Entry {
            right = List.copyOf(right);
        }
    }
}
