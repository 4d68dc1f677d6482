package arcomat.simulate.test;

/** What a run stands for that shows what a test expects. The best of several counts. */
enum Standing {
    /** The model may do this. */
    SURE,
    /** It may, but something was allowed, or guessed, only since something is in chaos. */
    VACUOUS,
    /** Not all that is left open could be tried: perhaps the model may not do this. */
    LOOSE;

    /** That of a run that has both behind it. */
    Standing and(Standing other) {
        return compareTo(other) < 0 ? other : this;
    }

    boolean isBetterThan(Standing other) {
        return compareTo(other) < 0;
    }
}
