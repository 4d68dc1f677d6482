package arcomat.campaign.statistics;

/**
 * A {@link SequentialTest} on its way. Trials that are told after the decision change nothing: what
 * is counted are those that led to it.
 */
public final class SequentialCourse {
    private final SequentialTest test;
    private long events;
    private long trials;
    private Decision decision = Decision.UNDECIDED;

    SequentialCourse(SequentialTest test) {
        this.test = test;
    }

    /** One trial more, in order. */
    public Decision see(boolean event) {
        if (decision == Decision.UNDECIDED) {
            trials++;
            events += event ? 1 : 0;
            decision = decide(test.evidence(events, trials));
        }
        return decision;
    }

    private Decision decide(double evidence) {
        if (evidence >= test.threshold()) {
            return Decision.HOLDS;
        }
        return evidence <= -test.threshold() ? Decision.FAILS : Decision.UNDECIDED;
    }

    public Decision decision() {
        return decision;
    }

    /** After how many trials it was decided; so far, where it is not. */
    public long trials() {
        return trials;
    }

    /** How many of them were events. */
    public long events() {
        return events;
    }
}
