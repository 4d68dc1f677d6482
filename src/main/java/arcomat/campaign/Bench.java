package arcomat.campaign;

import arcomat.campaign.statistics.Confidence;
import arcomat.campaign.statistics.ConfidenceInterval;
import arcomat.campaign.statistics.Decision;
import arcomat.campaign.statistics.FixedTest;
import arcomat.campaign.statistics.Measurements;
import arcomat.campaign.statistics.Proportion;
import arcomat.campaign.statistics.Quantile;
import arcomat.campaign.statistics.SampleSize;
import arcomat.campaign.statistics.SequentialCourse;
import arcomat.campaign.statistics.SequentialTest;

import java.util.function.Function;

/** One demand and what speaks for and against it so far. */
abstract class Bench {
    static Bench of(Demand demand, Campaign campaign) {
        return demand.match(
                probability -> new OfEvent(probability, campaign), share -> new OfShare(share));
    }

    /** A row that was made or given up. */
    abstract void see(Row row);

    abstract boolean isDecided();

    abstract Judgement judge(Function<String, Measurements> measured);

    /**
     * A demand on a probability; one that is to be above a bound is a demand that the contrary is
     * below the rest. A run that was given up counts against the demand: nobody knows how it would
     * have ended.
     */
    private static final class OfEvent extends Bench {
        private final Demand.Probability demand;
        private final int column;
        private final boolean sequential;
        private final FixedTest fixed;
        private final SequentialCourse course;
        private long bad;
        private long seen;

        OfEvent(Demand.Probability demand, Campaign campaign) {
            this.demand = demand;
            this.column = campaign.column(demand.event());
            this.sequential = campaign.stopsWhenDecided();
            Confidence confidence = new Confidence(demand.confidence());
            double bound = isBelow() ? demand.bound() : 1 - demand.bound();
            this.fixed = new FixedTest(bound, confidence);
            this.course = SequentialTest.below(bound, confidence).start();
        }

        private boolean isBelow() {
            return demand.side() == Demand.Side.BELOW;
        }

        @Override
        void see(Row row) {
            boolean against = !row.wasMade() || row.happened(column) == isBelow();
            seen++;
            bad += against ? 1 : 0;
            course.see(against);
        }

        @Override
        boolean isDecided() {
            return course.decision() != Decision.UNDECIDED;
        }

        @Override
        Judgement judge(Function<String, Measurements> measured) {
            String subject =
                    "%s %s %s at %s"
                            .formatted(
                                    demand.event(),
                                    demand.side().word(),
                                    number(demand.bound()),
                                    percent(demand.confidence()));
            if (sequential && isDecided()) {
                String when =
                        "decided by run %,d, %,d of them against it"
                                .formatted(course.trials(), course.events());
                return new Judgement(subject, true, course.decision(), when);
            }
            Proportion proportion = new Proportion(bad, seen);
            // Who might have stopped earlier must not be judged as if that had not been possible.
            Decision decision =
                    sequential || seen == 0 ? Decision.UNDECIDED : fixed.decide(proportion);
            return new Judgement(subject, true, decision, figures(proportion) + needed());
        }

        /** What a plan that is too small would have to be. */
        private String needed() {
            Confidence confidence = new Confidence(demand.confidence());
            double bound = isBelow() ? demand.bound() : 1 - demand.bound();
            long runs =
                    sequential
                            ? SequentialTest.below(bound, confidence).leastTrials()
                            : SampleSize.withoutEvents(bound, confidence);
            return seen < runs ? "; it takes %,d runs at least".formatted(runs) : "";
        }

        private String figures(Proportion proportion) {
            if (seen == 0) {
                return "no run was made";
            }
            Confidence confidence = new Confidence(demand.confidence());
            double low = proportion.atLeast(confidence);
            double high = proportion.atMost(confidence);
            long events = isBelow() ? bad : seen - bad;
            double least = isBelow() ? low : 1 - high;
            double most = isBelow() ? high : 1 - low;
            return "%,d of %,d runs; it is at most %s, and at least %s"
                    .formatted(events, seen, number(most), number(least));
        }
    }

    /** A demand on where most runs are. */
    private static final class OfShare extends Bench {
        private final Demand.Share demand;
        private long unknown;

        OfShare(Demand.Share demand) {
            this.demand = demand;
        }

        @Override
        void see(Row row) {
            unknown += row.wasMade() ? 0 : 1;
        }

        @Override
        boolean isDecided() {
            return false;
        }

        @Override
        Judgement judge(Function<String, Measurements> measured) {
            String subject =
                    "%s of %s %s %s at %s"
                            .formatted(
                                    percent(demand.share()),
                                    demand.measure(),
                                    demand.side().word(),
                                    number(demand.bound()),
                                    percent(demand.confidence()));
            Measurements numbers = measured.apply(demand.measure());
            if (numbers.size() == 0) {
                return new Judgement(subject, true, Decision.UNDECIDED, "no run was made");
            }
            if (unknown > 0) {
                String because = "%,d runs were given up".formatted(unknown);
                return new Judgement(subject, true, Decision.UNDECIDED, because);
            }
            // One side is asked about, so an interval may be wrong on that side alone.
            Confidence each = new Confidence(1 - 2 * (1 - demand.confidence()));
            Quantile quantile = new Quantile(demand.quantile());
            ConfidenceInterval interval = quantile.interval(numbers, each);
            String because = figures(quantile.estimate(numbers), interval);
            return new Judgement(subject, true, decide(interval), because);
        }

        private String figures(double estimate, ConfidenceInterval interval) {
            if (Double.isInfinite(estimate)) {
                return "too many runs never came to that, so there is no such number";
            }
            return "so many are %s %s; the truth is from %s to %s"
                    .formatted(
                            demand.side().word(),
                            number(estimate),
                            number(interval.low()),
                            number(interval.high()));
        }

        private Decision decide(ConfidenceInterval interval) {
            boolean below = demand.side() == Demand.Side.BELOW;
            boolean holds =
                    below ? interval.high() < demand.bound() : interval.low() > demand.bound();
            boolean fails =
                    below ? interval.low() >= demand.bound() : interval.high() <= demand.bound();
            if (holds) {
                return Decision.HOLDS;
            }
            return fails ? Decision.FAILS : Decision.UNDECIDED;
        }
    }

    static String percent(double share) {
        return number(share * 100);
    }

    /** With three digits that say something. */
    static String number(double value) {
        if (value == Math.rint(value) && Math.abs(value) < 1e9) {
            return Long.toString((long) value);
        }
        return Double.isInfinite(value)
                ? (value > 0 ? "anything" : "nothing")
                : new java.math.BigDecimal(value)
                        .round(new java.math.MathContext(3))
                        .stripTrailingZeros()
                        .toPlainString();
    }
}
