package arcomat.campaign.statistics;

/**
 * Whether two variants differ that were tried in pairs, on the same seeds: the exact test of
 * McNemar (Note on the sampling error of the difference between correlated proportions or
 * percentages, Psychometrika 12, 1947). Pairs in which both do the same say nothing; of the others
 * each is as likely better as worse, if the variants do not differ.
 *
 * @param better pairs in which only the second variant was good
 * @param worse pairs in which only the first one was
 */
public record McNemar(long better, long worse) {
    private static final double EITHER = 0.5;

    /**
     * How likely a difference as great as this or greater is, in whichever direction, if there is
     * none: where it is at most 0.05, "they differ" is wrong in one of 20 cases at most.
     */
    public double difference() {
        return Math.min(1, 2 * chance().atMost(Math.min(better, worse)));
    }

    /** How likely so many pairs, or more, are worse, if the second variant is not the worse one. */
    public double worsening() {
        return chance().atLeast(worse);
    }

    /**
     * How likely so many pairs, or more, are better, if the second variant is not the better one.
     */
    public double improvement() {
        return chance().atLeast(better);
    }

    /**
     * Whether the second variant is better or worse.
     *
     * @param error how often each of the two may be said at most where it is not so
     */
    public Decision decision(double error) {
        if (worsening() <= error) {
            return Decision.FAILS;
        }
        return improvement() <= error ? Decision.HOLDS : Decision.UNDECIDED;
    }

    private Binomial chance() {
        return new Binomial(better + worse, EITHER);
    }
}
