package arcomat.campaign.statistics;

import org.hipparchus.distribution.continuous.BetaDistribution;
import org.hipparchus.distribution.continuous.NormalDistribution;

/**
 * What is known of a probability after a number of trials that was settled beforehand.
 *
 * @param events trials in which it happened
 * @param trials all of them
 * @param groups of trials, as large as each other: those of different groups are independent, those
 *     of one may depend on each other in whichever way; as many as trials, where all are
 *     independent
 */
public record Proportion(long events, long trials, long groups) {
    /** Absolute, of a bound: that of one event in 10^9 runs is still right in six digits. */
    private static final double ACCURACY = 1e-15;

    public Proportion {
        if (events < 0 || events > trials || groups > trials) {
            throw new IllegalArgumentException(events + " of " + trials + " in " + groups);
        }
    }

    /** All trials are independent. */
    public Proportion(long events, long trials) {
        this(events, trials, trials);
    }

    /** The share of the trials; not a number where there are none. */
    public double estimate() {
        return (double) events / trials;
    }

    /**
     * The interval of Clopper and Pearson (The use of confidence or fiducial limits illustrated in
     * the case of the binomial, Biometrika 26, 1934): whatever the probability is, it is in there
     * at least as often as {@code confidence} says. For trials in groups it is that of {@link
     * ChernoffBound}, about their shares.
     */
    public ConfidenceInterval exact(Confidence confidence) {
        Confidence side = confidence.ofEachSide();
        return new ConfidenceInterval(atLeast(side), atMost(side));
    }

    /** What the probability is at most; that alone is as sure as {@code confidence} says. */
    public double atMost(Confidence confidence) {
        if (events == trials) {
            return 1;
        }
        return groups == trials
                ? quantile(events + 1, trials - events, confidence.level())
                : new ChernoffBound(groups, confidence.error()).averageAtMost(estimate());
    }

    /** What the probability is at least; that alone is as sure as {@code confidence} says. */
    public double atLeast(Confidence confidence) {
        if (events == 0) {
            return 0;
        }
        return groups == trials
                ? quantile(events, trials - events + 1, confidence.error())
                : new ChernoffBound(groups, confidence.error()).averageAtLeast(estimate());
    }

    private static double quantile(long alpha, long beta, double share) {
        return new BetaDistribution(alpha, beta, ACCURACY).inverseCumulativeProbability(share);
    }

    /**
     * The interval of Wilson (Probable inference, the law of succession, and statistical inference,
     * Journal of the American Statistical Association 22, 1927): shorter than the exact one, and
     * about as sure as {@code confidence} says: for some probabilities less. It is for looking at,
     * and for independent trials; what has to be proved goes by {@link #exact}.
     */
    public ConfidenceInterval wilson(Confidence confidence) {
        if (trials == 0) {
            return new ConfidenceInterval(0, 1);
        }
        double z =
                new NormalDistribution()
                        .inverseCumulativeProbability(confidence.ofEachSide().level());
        double share = estimate();
        double weight = z * z / trials;
        double middle = (share + weight / 2) / (1 + weight);
        double half = StrictMath.sqrt(weight * (share * (1 - share) + weight / 4)) / (1 + weight);
        return new ConfidenceInterval(
                events == 0 ? 0 : middle - half, events == trials ? 1 : middle + half);
    }
}
