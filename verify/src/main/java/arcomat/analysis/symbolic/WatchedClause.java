package arcomat.analysis.symbolic;

/**
 * A clause of a solver, in its own literals: twice a variable, and one more where it is negated.
 * The first two literals are watched.
 */
final class WatchedClause {
    final int[] literals;
    final boolean learnt;

    /** How useful it has been lately. */
    double activity;

    boolean removed;

    WatchedClause(int[] literals, boolean learnt) {
        this.literals = literals;
        this.learnt = learnt;
    }

    /** Makes a literal the first one. */
    void swap(int one, int other) {
        int literal = literals[one];
        literals[one] = literals[other];
        literals[other] = literal;
    }
}
