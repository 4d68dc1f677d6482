package arcomat.campaign;

import arcomat.source.Span;

import java.util.function.Function;

/** What a campaign is to show. */
public sealed interface Demand {
    /** Where the campaign asks for it. */
    Span place();

    /** Takes the sum apart: one answer for each form. */
    <R> R match(Function<Probability, R> probability, Function<Share, R> share);

    /** The side of a bound that is wanted. */
    enum Side {
        BELOW,
        ABOVE;

        /** As it is written. */
        public String word() {
            return name().toLowerCase(java.util.Locale.ROOT);
        }
    }

    /**
     * How often something happens.
     *
     * @param event the column of the table that says whether it did
     * @param bound from 0 to 1
     * @param confidence from 0 to 1: how sure one has to be
     */
    record Probability(String event, Side side, double bound, double confidence, Span place)
            implements Demand {
        @Override
        public <R> R match(Function<Probability, R> probability, Function<Share, R> share) {
            return probability.apply(this);
        }
    }

    /**
     * Where most runs are.
     *
     * @param quantile from 0 to 1: the share of the runs whose measure is smaller
     * @param measure a column of numbers
     * @param confidence from 0 to 1
     */
    record Share(
            double quantile, String measure, Side side, double bound, double confidence, Span place)
            implements Demand {
        @Override
        public <R> R match(Function<Probability, R> probability, Function<Share, R> share) {
            return share.apply(this);
        }
    }
}
