package arcomat.campaign.statistics;

import org.hipparchus.distribution.continuous.NormalDistribution;
import org.hipparchus.distribution.continuous.TDistribution;

import java.util.List;

/**
 * The probability of what is rare, by way of levels that are less so: importance splitting with a
 * fixed effort (Garvels, The splitting method in rare event simulation, 2000; L'Ecuyer, Demers,
 * Tuffin: Rare events, splitting, and quasi-Monte Carlo, ACM TOMACS 17, 2007). A number of trials
 * starts at the beginning; those of each further level start where trials of the one before have
 * reached it. Each of them has to draw its start among those, with equal chances and independently
 * of the other trials (two may draw the same one); and the number of trials of a level is settled
 * beforehand. Then the product of the shares is right on average, however many trials there are
 * (Del Moral, Feynman-Kac Formulae, 2004, section 7.4).
 *
 * @param levels in order; the last one is what is asked about. Where none has reached a level,
 *     there is no further one
 */
public record Splitting(List<Level> levels) {
    /**
     * @param started trials, at least 2
     * @param reached how many of them came to the next level
     */
    public record Level(long started, long reached) {
        public Level {
            if (started < 2 || reached < 0 || reached > started) {
                throw new IllegalArgumentException(reached + " of " + started);
            }
        }

        private double share() {
            return (double) reached / started;
        }
    }

    public Splitting {
        levels = List.copyOf(levels);
        if (levels.isEmpty()) {
            throw new IllegalArgumentException("no level");
        }
    }

    /**
     * Right on average. Zero where nothing came to the end, which says little: see the interval.
     */
    public double estimate() {
        return levels.stream().mapToDouble(Level::share).reduce(1, (a, b) -> a * b);
    }

    /**
     * Where the probability is, if what happens after a level does not depend on where in it a
     * trial starts, so that the shares are independent of each other: that is so where a level is a
     * single state, and hardly ever in a world. Else the interval is too short, and {@link
     * #interval(Families, Confidence)} is to be asked. The logarithm of the product is taken as
     * normal, with the sum of the variances of the levels.
     */
    public ConfidenceInterval intervalOfIndependentLevels(Confidence confidence) {
        if (last().reached() == 0) {
            return ofTheFirstLevel(confidence);
        }
        double spread = 0;
        for (Level each : levels) {
            spread += (1 - each.share()) / each.reached();
        }
        double quantile =
                new NormalDistribution()
                        .inverseCumulativeProbability(confidence.ofEachSide().level());
        return around(quantile * StrictMath.sqrt(spread));
    }

    /**
     * Where the probability is, from one splitting whose trials depend on each other through their
     * common ancestors. Its {@link #variance} is exact on average; the rest is an approximation:
     * the logarithm of the product is taken as normal, and the variance as known as well as so many
     * independent values tell it as there are families (Student's t). So it needs families in the
     * tens, and with a single one it knows nothing.
     */
    public ConfidenceInterval interval(Families families, Confidence confidence) {
        if (families.count() < 2) {
            return ofTheFirstLevel(confidence);
        }
        double estimate = estimate();
        double relative = Math.max(0, variance(families)) / (estimate * estimate);
        double quantile =
                new TDistribution(families.count() - 1)
                        .inverseCumulativeProbability(confidence.ofEachSide().level());
        return around(quantile * StrictMath.sqrt(StrictMath.log1p(relative)));
    }

    /**
     * The variance of the estimate, itself right on average (Lee, Whiteley: Variance estimation in
     * the particle filter, Biometrika 105, 2018, theorem 1, for numbers of trials that differ from
     * level to level): two trials of different families are as good as two of different splittings,
     * so that the pairs of such tell the square of the probability. By chance it may be below zero.
     */
    double variance(Families families) {
        if (families.members() != last().reached()) {
            throw new IllegalArgumentException(
                    families.members() + " in families, " + last().reached() + " at the end");
        }
        double square = families.strangers() / last().reached() / last().reached();
        for (Level each : levels) {
            square *= each.share() * each.share() * each.started() / (each.started() - 1);
        }
        return estimate() * estimate() - square;
    }

    private Level last() {
        return levels.get(levels.size() - 1);
    }

    private ConfidenceInterval around(double logarithm) {
        double factor = StrictMath.exp(logarithm);
        return new ConfidenceInterval(estimate() / factor, Math.min(1, estimate() * factor));
    }

    /**
     * All that is sure where no trial came to the end, or all that came are of one family: nothing
     * is more likely than to reach the first level. What the others add depends on where in them
     * trials started.
     */
    private ConfidenceInterval ofTheFirstLevel(Confidence confidence) {
        Level first = levels.get(0);
        return new ConfidenceInterval(
                0, new Proportion(first.reached(), first.started()).atMost(confidence));
    }
}
