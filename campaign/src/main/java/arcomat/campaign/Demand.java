package arcomat.campaign;

import arcomat.source.Span;

import java.util.Locale;
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
            return name().toLowerCase(Locale.ROOT);
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
     * On which side of a bound most runs are.
     *
     * @param share from 0 to 1: of the runs that have to be on that side
     * @param measure a column of numbers
     * @param confidence from 0 to 1
     */
    record Share(
            double share, String measure, Side side, double bound, double confidence, Span place)
            implements Demand {
        /**
         * The share of the runs below the number that is asked about: where most are to be above a
         * bound, it is the rest of them.
         */
        double quantile() {
            return side == Side.BELOW ? share : 1 - share;
        }

        @Override
        public <R> R match(Function<Probability, R> probability, Function<Share, R> share) {
            return share.apply(this);
        }
    }
}
