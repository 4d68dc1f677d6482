package arcomat.campaign.statistics;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Arrays;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;

/** Quantiles of columns. */
class QuantileTest {
    private static final Confidence SURE = new Confidence(0.95);

    private static Measurements of(double... values) {
        return Measurements.of(() -> Arrays.stream(values));
    }

    private static Measurements upTo(long last) {
        return Measurements.of(() -> LongStream.rangeClosed(1, last).asDoubleStream());
    }

    /** As by sorting, whatever the numbers are: the tool's own order of doubles is Java's. */
    @Property(tries = 60)
    void ranksAreThoseOfSorting(@ForAll @Size(min = 1, max = 40) double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        for (int rank = 1; rank <= sorted.length; rank++) {
            assertThat(of(values).ranked(rank)).isEqualTo(sorted[rank - 1]);
            assertThat(Measurements.of(() -> Arrays.stream(values), 2).ranked(rank))
                    .as("with no more than two in memory")
                    .isEqualTo(sorted[rank - 1]);
        }
    }

    @Test
    void infinityAndWhatIsNoNumberHaveRanks() {
        double[] values = {
            Double.NaN, 0.0, Double.POSITIVE_INFINITY, -0.0, Double.NEGATIVE_INFINITY, 2
        };
        Measurements odd = Measurements.of(() -> Arrays.stream(values), 0);
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
}
