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
                probability -> new OfEvent(probability, campaign),
                share -> new OfShare(share, campaign));
    }

    /** A row that was made or given up. */
    abstract void see(Row row);

    abstract boolean isDecided();

    abstract Judgement judge(Function<String, Measurements> measured);

    /** Where runs share seeds, it is seeds that count. */
    private static String onSeeds(long seeds, long runs) {
        return seeds < runs ? " on %,d %s".formatted(seeds, seeds == 1 ? "seed" : "seeds") : "";
    }

    /** Nobody knows what they would have said: they count against whatever is wanted. */
    private static String withoutAnswer(long runs, String what) {
        return runs == 0
                ? ""
                : "; %,d without %s %s against it"
                        .formatted(runs, what, runs == 1 ? "counts" : "count");
    }

    /**
     * A demand on a probability; one that is to be above a bound is a demand that the contrary is
     * below the rest. A run that was given up, or does not say whether it happened, counts against
     * the demand: nobody knows.
     */
    private static final class OfEvent extends Bench {
        private final Demand.Probability demand;
        private final Campaign campaign;
        private final int column;
        private final boolean sequential;
        private final Confidence confidence;
        private final double bound;
        private final SequentialTest test;
        private final SequentialCourse course;
        private long bad;
        private long unknown;
        private long seen;

        OfEvent(Demand.Probability demand, Campaign campaign) {
            this.demand = demand;
            this.campaign = campaign;
            this.column = campaign.column(demand.event());
            this.sequential = campaign.stopsWhenDecided();
            this.confidence = new Confidence(demand.confidence());
            this.bound = isBelow() ? demand.bound() : 1 - demand.bound();
            this.test = SequentialTest.below(bound, confidence);
            this.course = test.start();
        }

        private boolean isBelow() {
            return demand.side() == Demand.Side.BELOW;
        }

        @Override
        void see(Row row) {
            boolean known = row.answers(column);
            boolean against = !known || row.happened(column) == isBelow();
            seen++;
            unknown += known ? 0 : 1;
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
                                    Figure.text(demand.bound()),
                                    Figure.percent(demand.confidence()));
            if (sequential && isDecided()) {
                String when =
                        "decided by run %,d, %,d of them against it"
                                .formatted(course.trials(), course.events());
                return new Judgement(subject, true, course.decision(), when, demand.place());
            }
            Proportion proportion = new Proportion(bad, seen, campaign.seeds(seen));
            // Who might have stopped earlier must not be judged as if that had not been possible.
            Decision decision =
                    sequential || seen == 0
                            ? Decision.UNDECIDED
                            : new FixedTest(bound, confidence).decide(proportion);
            String because =
                    figures(proportion) + withoutAnswer(unknown, "an answer") + needed(proportion);
            return new Judgement(subject, true, decision, because, demand.place());
        }

        /** What a plan that is too small would have to be. */
        private String needed(Proportion proportion) {
            long least =
                    sequential ? test.leastTrials() : SampleSize.withoutEvents(bound, confidence);
            String what = proportion.groups() < seen ? "seeds" : "runs";
            return proportion.groups() < least
                    ? "; it takes %,d %s at least".formatted(least, what)
                    : "";
        }

        private String figures(Proportion proportion) {
            if (seen == 0) {
                return "no run was made";
            }
            double low = proportion.atLeast(confidence);
            double high = proportion.atMost(confidence);
            long events = isBelow() ? bad : seen - bad;
            double least = isBelow() ? low : 1 - high;
            double most = isBelow() ? high : 1 - low;
            return "%,d of %,d runs%s; it is at most %s, and at least %s"
                    .formatted(
                            events,
                            seen,
                            onSeeds(proportion.groups(), seen),
                            Figure.text(most),
                            Figure.text(least));
        }
    }

    /**
     * A demand on where most runs are. A run without a number is on the side that is not wanted,
     * beyond any bound: left out, it would make a share of all runs one of those that please.
     */
    private static final class OfShare extends Bench {
        private final Demand.Share demand;
        private final Campaign campaign;
        private final int column;
        private long unknown;

        OfShare(Demand.Share demand, Campaign campaign) {
            this.demand = demand;
            this.campaign = campaign;
            this.column = campaign.column(demand.measure());
        }

        @Override
        void see(Row row) {
            unknown += row.answers(column) ? 0 : 1;
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
                                    Figure.percent(demand.share()),
                                    demand.measure(),
                                    demand.side().word(),
                                    Figure.text(demand.bound()),
                                    Figure.percent(demand.confidence()));
            Measurements numbers = measured.apply(demand.measure()).with(unwanted(), unknown);
            if (numbers.size() == 0) {
                return new Judgement(
                        subject, true, Decision.UNDECIDED, "no run was made", demand.place());
            }
            // One side is asked about, so an interval may be wrong on that side alone.
            Confidence each = new Confidence(1 - 2 * (1 - demand.confidence()));
            Quantile quantile = new Quantile(demand.quantile());
            long seeds = campaign.seeds(numbers.size());
            ConfidenceInterval interval = quantile.interval(numbers, seeds, each);
            String because =
                    figures(quantile.estimate(numbers), interval)
                            + (seeds < numbers.size() ? "," : "")
                            + onSeeds(seeds, numbers.size())
                            + withoutAnswer(unknown, "a number");
            return new Judgement(subject, true, decide(interval), because, demand.place());
        }

        /** A number that is on the wrong side of every bound. */
        private double unwanted() {
            return demand.side() == Demand.Side.BELOW
                    ? Double.POSITIVE_INFINITY
                    : Double.NEGATIVE_INFINITY;
        }

        private String figures(double estimate, ConfidenceInterval interval) {
            if (Double.isInfinite(estimate)) {
                return "too many runs never came to that, so there is no such number";
            }
            return "so many are %s %s; the truth is from %s to %s"
                    .formatted(
                            demand.side().word(),
                            Figure.text(estimate),
                            end(interval.low()),
                            end(interval.high()));
        }

        /** An end that too few runs tell may be anywhere. */
        private static String end(double value) {
            if (Double.isInfinite(value)) {
                return value > 0 ? "anything" : "nothing";
            }
            return Figure.text(value);
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
}
