package arcomat.campaign.statistics;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.function.LongPredicate;

/**
 * The number that a share of all runs does not exceed: the smallest one of which that is true.
 * Nothing is supposed of how numbers are spread, and equal ones may be many.
 *
 * @param share between 0 and 1, such as 0.95; 0.5 is the median
 */
public record Quantile(double share) {
    public Quantile {
        if (!(share > 0 && share < 1)) {
            throw new IllegalArgumentException("share " + share + " is not between 0 and 1");
        }
    }

    /** That of the numbers that were measured, of which there is at least one. */
    public double estimate(Measurements measured) {
        // As it is written: 0.07 of 100 is 7, and not what is above 7.000000000000001.
        BigDecimal rank = BigDecimal.valueOf(share).multiply(BigDecimal.valueOf(measured.size()));
        return measured.ranked(rank.setScale(0, RoundingMode.CEILING).longValueExact());
    }

    /**
     * Two of the numbers that were measured, independently of each other, between which the
     * quantile of all runs is at least as often as {@code confidence} says (order statistics:
     * David, Nagaraja, Order Statistics, 3rd edition 2003, section 7.1). An end is infinite where
     * there are too few numbers to say.
     */
    public ConfidenceInterval interval(Measurements measured, Confidence confidence) {
        Binomial smaller = new Binomial(measured.size(), share);
        double error = confidence.ofEachSide().error();
        long above = first(measured.size(), rank -> smaller.atMost(rank - 1) > error);
        long high = first(measured.size(), rank -> smaller.atLeast(rank) <= error);
        return new ConfidenceInterval(
                above <= 1 ? Double.NEGATIVE_INFINITY : measured.ranked(above - 1),
                high > measured.size() ? Double.POSITIVE_INFINITY : measured.ranked(high));
    }

    /**
     * The same, where numbers come in groups that are as large as each other, and only those of
     * different groups are independent ({@link ChernoffBound}, of the share of each group that does
     * not exceed the quantile, and of the one that is smaller).
     *
     * @param groups as many as numbers, where all are independent
     */
    public ConfidenceInterval interval(Measurements measured, long groups, Confidence confidence) {
        if (groups == measured.size()) {
            return interval(measured, confidence);
        }
        ChernoffBound bound = new ChernoffBound(groups, confidence.ofEachSide().error());
        long low = (long) StrictMath.ceil(bound.meanAtLeast(share) * measured.size());
        long high = (long) StrictMath.floor(bound.meanAtMost(share) * measured.size()) + 1;
        return new ConfidenceInterval(
                low < 1 ? Double.NEGATIVE_INFINITY : measured.ranked(low),
                high > measured.size() ? Double.POSITIVE_INFINITY : measured.ranked(high));
    }

    /**
     * The first rank from 1 that is so, where all after it are so, too; else the one after the
     * last.
     */
    private static long first(long ranks, LongPredicate so) {
        long low = 1;
        long high = ranks + 1;
        while (low < high) {
            long middle = low + (high - low) / 2;
            if (so.test(middle)) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        return low;
    }
}
