package arcomat.campaign.statistics;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Arrays;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;

/** Quantiles of columns, and how often their intervals are right. */
class QuantileTest {
    private static final Confidence SURE = new Confidence(0.95);

    private static Measurements of(double... values) {
        return Measurements.of(() -> Arrays.stream(values));
    }

    private static Measurements upTo(long last) {
        return Measurements.of(() -> LongStream.rangeClosed(1, last).asDoubleStream());
    }

    /** As by sorting, whatever the numbers are: the tool's own order of doubles is Java's. */
    @Property(tries = 200)
    void ranksAreThoseOfSorting(@ForAll @Size(min = 1, max = 40) double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        for (int rank = 1; rank <= sorted.length; rank++) {
            assertThat(of(values).ranked(rank)).isEqualTo(sorted[rank - 1]);
        }
    }

    @Test
    void infinityAndWhatIsNoNumberHaveRanks() {
        Measurements odd =
                of(Double.NaN, 0.0, Double.POSITIVE_INFINITY, -0.0, Double.NEGATIVE_INFINITY, 2);
        assertThat(
                        DoubleStream.iterate(1, rank -> rank <= 6, rank -> rank + 1)
                                .map(rank -> odd.ranked((long) rank)))
                .containsExactly(
                        Double.NEGATIVE_INFINITY,
                        -0.0,
                        0.0,
                        2.0,
                        Double.POSITIVE_INFINITY,
                        Double.NaN);
    }

    @ParameterizedTest
    @CsvSource({"0.5, 9, 5", "0.5, 10, 5", "0.07, 100, 7", "0.95, 100, 95", "0.95, 101, 96"})
    void theEstimateIsTheSmallestThatTheShareDoesNotExceed(double share, long size, double rank) {
        assertThat(new Quantile(share).estimate(upTo(size))).isEqualTo(rank);
    }

    /**
     * Ranks for the median at 0.95: Conover, Practical Nonparametric Statistics, 3rd edition 1999,
     * table A3 of the binomial distribution; for 10 numbers the second and the ninth.
     */
    @ParameterizedTest
    @CsvSource({
        "0.5,  5,   -Infinity, Infinity",
        "0.5,  6,   1,         6",
        "0.5,  10,  2,         9",
        "0.5,  20,  6,         15",
        "0.5,  100, 40,        61",
        "0.95, 58,  51,        Infinity",
        "0.95, 100, 90,        100"
    })
    void theIntervalIsOfOrderStatistics(double share, long size, double low, double high) {
        assertThat(new Quantile(share).interval(upTo(size), SURE))
                .isEqualTo(new ConfidenceInterval(low, high));
    }

    @Test
    void aColumnNeedNotFitIntoMemory() {
        // Scattered, but each number once: 7919 is prime to the size.
        long size = 3_000_000;
        Measurements many =
                Measurements.of(
                        () -> LongStream.range(0, size).mapToDouble(i -> i * 7919 % size + 1));
        assertThat(new Quantile(0.999).estimate(many)).isEqualTo(2_997_000);
    }

    @Test
    void theIntervalIsRightOftenEnough(TestReporter reporter) {
        check(
                "exponential, 0.9",
                0.9,
                Math.log(10),
                random -> -Math.log(random.nextDouble()),
                reporter);
        check("dice, median", 0.5, 3, random -> 1 + random.nextInt(6), reporter);
        check("few arrive, 0.95", 0.95, Double.POSITIVE_INFINITY, QuantileTest::arrival, reporter);
    }

    /** Seconds; one of twelve does not arrive. */
    private static double arrival(Random random) {
        return random.nextInt(12) == 0 ? Double.POSITIVE_INFINITY : 10 + random.nextDouble();
    }

    private static void check(
            String what,
            double share,
            double truth,
            ToDoubleFunction<Random> measure,
            TestReporter reporter) {
        Repetitions repetitions = new Repetitions(400, 19);
        double right =
                repetitions.share(
                        random -> {
                            double[] values =
                                    DoubleStream.generate(() -> measure.applyAsDouble(random))
                                            .limit(120)
                                            .toArray();
                            return new Quantile(share).interval(of(values), SURE).contains(truth);
                        });
        reporter.publishEntry("quantile at 0.95, " + what, "" + right);
        assertThat(right).as(what).isGreaterThanOrEqualTo(0.95 - repetitions.allowance(0.95));
    }
}
