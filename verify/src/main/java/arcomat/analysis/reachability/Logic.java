package arcomat.analysis.reachability;

import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * What a solver can be told about the runs of an automaton: formulas, claims, and whether all can
 * be true. What it has no formula for may be anything; so what it says is impossible is so.
 *
 * @param <T> its formulas: truth values and all others
 */
public interface Logic<T> {
    /** Whether what was claimed can be true. */
    enum Answer {
        YES,
        NO,
        UNKNOWN
    }

    /**
     * Solvers of one kind.
     *
     * @param <T> their formulas
     */
    interface Kind<T> {
        /**
         * One that nothing has been claimed to.
         *
         * @param stop asked now and then; an answer is unknown once it is true
         */
        Logic<T> about(Subject subject, BooleanSupplier stop);
    }

    T of(boolean truth);

    T and(List<T> all);

    T or(List<T> any);

    T not(T condition);

    /** From now on it is true. */
    void claim(T condition);

    /** Whether all that was claimed can be true if some formulas are; these are forgotten again. */
    Answer assuming(List<T> conditions);

    /**
     * As above.
     *
     * @param ifYes may look at an example, which is easy to read if it can be
     */
    Answer assuming(List<T> conditions, Runnable ifYes);

    /** A new point of a run. */
    Instant<T> instant();

    /** Whether nothing so far had to be replaced by something that may be anything. */
    boolean isExact();
}
