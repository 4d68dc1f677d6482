package arcomat.campaign.statistics;

import java.util.function.DoublePredicate;

/**
 * How far the mean of independent numbers from 0 to 1 is from what it is on average: the bound of
 * Chernoff and Hoeffding (Hoeffding: Probability inequalities for sums of bounded random variables,
 * Journal of the American Statistical Association 58, 1963, theorem 1). It asks no more of the
 * numbers than that, so they may be shares of trials that depend on each other in whichever way.
 *
 * @param count of the numbers
 * @param error how often a bound may be wrong, on one side
 */
record ChernoffBound(long count, double error) {
    /** A double has no more places. */
    private static final int HALVINGS = 60;

    /** What they are on average is no greater. */
    double averageAtMost(double mean) {
        return last(mean, 1, average -> isLikely(mean, average));
    }

    /** What they are on average is no smaller. */
    double averageAtLeast(double mean) {
        return last(mean, 0, average -> isLikely(mean, average));
    }

    /** The mean is no greater. */
    double meanAtMost(double average) {
        return last(average, 1, mean -> isLikely(mean, average));
    }

    /** The mean is no smaller. */
    double meanAtLeast(double average) {
        return last(average, 0, mean -> isLikely(mean, average));
    }

    private boolean isLikely(double mean, double average) {
        return count == 0 || count * divergence(mean, average) <= -StrictMath.log(error);
    }

    /** Of Kullback and Leibler, between two coins. */
    private static double divergence(double mean, double average) {
        return part(mean, average) + part(1 - mean, 1 - average);
    }

    private static double part(double mean, double average) {
        return mean <= 0 ? 0 : mean * StrictMath.log(mean / average);
    }

    /** The first number on the way to an end that is not so any more; the end, if all are. */
    private static double last(double start, double end, DoublePredicate so) {
        if (so.test(end)) {
            return end;
        }
        double inside = start;
        double outside = end;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = inside + (outside - inside) / 2;
            if (so.test(middle)) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        return outside;
    }
}
