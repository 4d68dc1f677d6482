package arcomat.campaign.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;

/** Importance splitting, on walks whose probabilities are known. */
class SplittingTest {
    private static final Confidence SURE = new Confidence(0.95);

    @ParameterizedTest
    @CsvSource({"15, 0.4, 0.4", "21, 0.4, 0.4", "15, 0.45, 0.3"})
    void isRightOnAverage(int goal, double luck, double other) {
        RuinedGambler gambler = new RuinedGambler(List.of(luck, other), goal);
        SplittableRandom random = new SplittableRandom(21);
        int count = 1000;
        double sum = 0;
        double squares = 0;
        double variances = 0;
        for (int i = 0; i < count; i++) {
            RuinedGambler.Outcome split = gambler.split(100, random);
            double estimate = split.splitting().estimate();
            sum += estimate;
            squares += estimate * estimate;
            variances += split.variance();
        }
        double mean = sum / count;
        double variance = squares / count - mean * mean;
        assertThat(mean).isCloseTo(gambler.probability(), within(4 * Math.sqrt(variance / count)));
        assertThat(variances / count / variance)
                .as("variance as the families tell it")
                .isBetween(0.75, 1.25);
    }

    /** With one level it is a proportion, and each trial is a family. */
    @Test
    void aSingleLevelIsAProportion() {
        Splitting single = new Splitting(List.of(new Splitting.Level(100, 20)));
        Families families = new Families(Collections.nCopies(20, 1L));
        assertThat(single.estimate()).isEqualTo(0.2);
        assertThat(single.variance(families)).isCloseTo(0.2 * 0.8 / 99, within(1e-15));
    }

    @Test
    void whereNothingArrivesTheFirstLevelIsWhatOneIsSureOf() {
        Splitting empty =
                new Splitting(List.of(new Splitting.Level(100, 20), new Splitting.Level(50, 0)));
        ConfidenceInterval sure = new ConfidenceInterval(0, new Proportion(20, 100).atMost(SURE));
        assertThat(empty.estimate()).isZero();
        assertThat(empty.interval(new Families(List.of()), SURE)).isEqualTo(sure);
        assertThat(empty.intervalOfIndependentLevels(SURE)).isEqualTo(sure);
    }

    @Test
    void oneFamilyKnowsNoMore() {
        Splitting split =
                new Splitting(List.of(new Splitting.Level(100, 20), new Splitting.Level(50, 5)));
        assertThat(split.interval(new Families(List.of(5L)), SURE).high())
                .isEqualTo(new Proportion(20, 100).atMost(SURE));
    }
}
