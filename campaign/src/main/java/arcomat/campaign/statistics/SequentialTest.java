package arcomat.campaign.statistics;

/**
 * Whether the probability p of an event is below {@code bound}, asked anew after every trial, so
 * that it ends as soon as it is decided: the sequential probability ratio test (Wald: Sequential
 * tests of statistical hypotheses, Annals of Mathematical Statistics 16, 1945) of "p = bound"
 * against "p = near", where {@code near} is a smaller probability. With an error of 1 - confidence:
 *
 * <ul>
 *   <li>where {@code p >= bound}, it ever says {@code HOLDS} with a probability of at most the
 *       error;
 *   <li>where {@code p <= near}, it ever says {@code FAILS} with a probability of at most the
 *       error;
 *   <li>where p lies between the two, it says either. So {@code FAILS} proves that p is greater
 *       than {@code near}, and not that it is greater than the bound.
 * </ul>
 *
 * This is true for any number of trials and whenever one stops, not only about, as it is of Wald's
 * own limits: a ratio of likelihoods that is right on average is ever greater than 1/error with a
 * probability of at most the error (Ville's inequality), and for p beyond the bound it only
 * shrinks. Trials have to be independent, and to be told in an order that does not depend on what
 * comes out of them.
 *
 * @param bound what the probability has to be below; between 0 and 1, both excluded
 * @param near from where on the test may not fail; between 0 and {@code bound}, both excluded
 */
public record SequentialTest(double bound, double near, Confidence confidence) {
    public SequentialTest {
        if (!(0 < near && near < bound && bound < 1)) {
            throw new IllegalArgumentException("0 < " + near + " < " + bound + " < 1 is wrong");
        }
    }

    /**
     * Where only the bound is given, {@code near} has half its odds: of 0.001 it is 0.0005. Closer
     * to the bound takes many more trials, by the square; farther away says of too much that it
     * fails.
     */
    public static SequentialTest below(double bound, Confidence confidence) {
        return new SequentialTest(bound, bound / (2 - bound), confidence);
    }

    /** Begins with no trial. */
    public SequentialCourse start() {
        return new SequentialCourse(this);
    }

    /** How many trials it takes at least: as many without a single event make it hold. */
    public long leastTrials() {
        return (long) StrictMath.ceil(threshold() / evidenceOfNone());
    }

    /**
     * How many trials it takes on average where p is such that it is hardest to decide, somewhere
     * between {@code near} and the bound; about (Wald's approximation, which neglects by how much
     * the last trial exceeds the threshold).
     */
    public long trialsOfTheHardest() {
        double none = evidenceOfNone();
        double one = evidenceOfOne();
        double probability = none / (none - one);
        double spread = (1 - probability) * none * none + probability * one * one;
        return (long) StrictMath.ceil(threshold() * threshold() / spread);
    }

    /** The logarithm of the ratio of likelihoods: positive speaks for it. */
    double evidence(long events, long trials) {
        return events * evidenceOfOne() + (trials - events) * evidenceOfNone();
    }

    /** How much evidence decides, in either direction. */
    double threshold() {
        return -StrictMath.log(confidence.error());
    }

    private double evidenceOfOne() {
        return StrictMath.log(near / bound);
    }

    private double evidenceOfNone() {
        return StrictMath.log1p(-near) - StrictMath.log1p(-bound);
    }
}
