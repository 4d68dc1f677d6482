package arcomat.campaign.statistics;

import org.hipparchus.special.Beta;

/**
 * How many of {@code trials} happen, each with {@code probability}. Hipparchus has it for numbers
 * that fit in an int; the incomplete beta function, by which it is computed, goes further.
 */
record Binomial(long trials, double probability) {
    /** The probability that no more than {@code count} happen. */
    double atMost(long count) {
        return count < 0
                ? 0
                : share(1 - probability, (double) (trials - count), (double) (count + 1));
    }

    /** The probability that {@code count} happen, or more. */
    double atLeast(long count) {
        return count > trials
                ? 0
                : share(probability, (double) count, (double) (trials - count + 1));
    }

    /** Of {@code yes + no - 1} trials {@code yes} happen, or more. */
    private static double share(double probability, double yes, double no) {
        return yes <= 0 ? 1 : Beta.regularizedBeta(probability, yes, no);
    }
}
