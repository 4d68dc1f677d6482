package arcomat.campaign.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.SplittableRandom;
import java.util.stream.IntStream;

/** Trials that share their chance are no more witnesses than there are chances. */
class GroupedTrialsTest {
    private static final Confidence SURE = new Confidence(0.95);
    private static final int REPETITIONS = 2000;
    private static final int GROUPS = 30;
    private static final int EACH = 10;

    /** Where nothing happened it is as if each group were one trial. */
    @ParameterizedTest
    @CsvSource({"1", "5", "59", "299"})
    void withoutEventsGroupsAreTrials(long groups) {
        assertThat(new Proportion(0, 20 * groups, groups).atMost(SURE))
                .isCloseTo(new Proportion(0, groups).atMost(SURE), within(1e-9));
    }

    @Test
    void independentTrialsKeepTheirShorterInterval() {
        ConfidenceInterval grouped = new Proportion(30, 100, 20).exact(SURE);
        ConfidenceInterval free = new Proportion(30, 100).exact(SURE);
        assertThat(grouped.low()).isLessThan(free.low()).isPositive();
        assertThat(grouped.high()).isGreaterThan(free.high()).isLessThan(1);
        assertThat(new Proportion(30, 100, 100).exact(SURE)).isEqualTo(free);
    }

    /** All trials of a group do the same: the worst that groups can be. */
    @ParameterizedTest
    @CsvSource({"0.05", "0.2", "0.5"})
    void anUpperBoundIsRightThoughAllOfAGroupAreOne(double probability) {
        int grouped = 0;
        int taken = 0;
        for (int repetition = 0; repetition < REPETITIONS; repetition++) {
            long events = EACH * events(probability, repetition);
            grouped +=
                    new Proportion(events, GROUPS * EACH, GROUPS).atMost(SURE) < probability
                            ? 1
                            : 0;
            taken += new Proportion(events, GROUPS * EACH).atMost(SURE) < probability ? 1 : 0;
        }
        assertThat((double) grouped / REPETITIONS).isLessThanOrEqualTo(0.05);
        assertThat((double) taken / REPETITIONS).as("taken as independent").isGreaterThan(0.1);
    }

    private static long events(double probability, int repetition) {
        SplittableRandom chance = new SplittableRandom(repetition);
        return IntStream.range(0, GROUPS).filter(i -> chance.nextDouble() < probability).count();
    }

    /** Each number comes ten times: the median of all is between these in 95 of 100 cases. */
    @Test
    void anIntervalOfAQuantileIsRightThoughAllOfAGroupAreOne() {
        int grouped = 0;
        int taken = 0;
        for (int repetition = 0; repetition < REPETITIONS; repetition++) {
            double[] numbers = new SplittableRandom(repetition).doubles(GROUPS).toArray();
            Measurements all =
                    Measurements.of(
                            () ->
                                    IntStream.range(0, GROUPS * EACH)
                                            .mapToDouble(i -> numbers[i / EACH]));
            Quantile median = new Quantile(0.5);
            grouped += median.interval(all, GROUPS, SURE).contains(0.5) ? 1 : 0;
            taken += median.interval(all, SURE).contains(0.5) ? 1 : 0;
        }
        assertThat((double) grouped / REPETITIONS).isGreaterThanOrEqualTo(0.95);
        assertThat((double) taken / REPETITIONS).as("taken as independent").isLessThan(0.8);
    }
}
