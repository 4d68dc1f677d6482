package arcomat.campaign.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Collections;
import java.util.List;
import java.util.Random;

/** Importance splitting against brute force, on walks whose probabilities are known. */
class SplittingTest {
    private static final Confidence SURE = new Confidence(0.95);

    /** All of the same luck: 0.00114 and 0.000100. */
    private static RuinedGambler alike(int goal) {
        return new RuinedGambler(List.of(0.4), goal);
    }

    /** Half of them hardly ever come far: who reaches a level is no sample of all. */
    private static RuinedGambler different(int goal) {
        return new RuinedGambler(List.of(0.45, 0.3), goal);
    }

    @ParameterizedTest
    @CsvSource({"15, 0.00114, 1000000", "21, 0.0001, 2000000"})
    void agreesWithBruteForce(int goal, double about, int walks, TestReporter reporter) {
        RuinedGambler gambler = alike(goal);
        Random random = new Random(20);
        long wins = 0;
        for (int i = 0; i < walks; i++) {
            wins += gambler.wins(random) ? 1 : 0;
        }
        ConfidenceInterval brute = new Proportion(wins, walks).exact(new Confidence(0.999));
        RuinedGambler.Outcome split = gambler.split(20_000, random);
        ConfidenceInterval interval =
                split.splitting().intervalOfIndependentLevels(new Confidence(0.999));
        reporter.publishEntry(
                "p = " + gambler.probability(),
                "brute force " + brute + ", splitting " + split.splitting().estimate() + interval);
        assertThat(gambler.probability()).isCloseTo(about, within(about / 100));
        assertThat(brute.contains(gambler.probability())).isTrue();
        assertThat(interval.contains(gambler.probability())).isTrue();
        assertThat(brute.contains(split.splitting().estimate())).isTrue();
    }

    @ParameterizedTest
    @CsvSource({"15, false", "21, false", "15, true"})
    void isRightOnAverage(int goal, boolean different, TestReporter reporter) {
        RuinedGambler gambler = different ? different(goal) : alike(goal);
        Random random = new Random(21);
        int count = 2000;
        double sum = 0;
        double squares = 0;
        double variances = 0;
        for (int i = 0; i < count; i++) {
            RuinedGambler.Outcome split = gambler.split(100, random);
            double estimate = split.splitting().estimate();
            sum += estimate;
            squares += estimate * estimate;
            variances += estimate > 0 ? split.splitting().variance(split.families()) : 0;
        }
        double mean = sum / count;
        double variance = squares / count - mean * mean;
        double error = Math.sqrt(variance / count);
        reporter.publishEntry(
                "p = " + gambler.probability(),
                "mean %s, %s standard errors away; variance %s, told by families %s"
                        .formatted(
                                mean,
                                (mean - gambler.probability()) / error,
                                variance,
                                variances / count));
        assertThat(mean).isCloseTo(gambler.probability(), within(4 * error));
        assertThat(variances / count / variance).isBetween(0.75, 1.25);
    }

    @Test
    void intervalsAreRightAboutOftenEnough(TestReporter reporter) {
        Repetitions repetitions = new Repetitions(1000, 22);
        double alike = coverage(repetitions, alike(15), false);
        double families = coverage(repetitions, alike(15), true);
        double different = coverage(repetitions, different(15), true);
        double wrong = coverage(repetitions, different(15), false);
        reporter.publishEntry("independent levels, walkers alike", "" + alike);
        reporter.publishEntry("families, walkers alike", "" + families);
        reporter.publishEntry("families, walkers different", "" + different);
        reporter.publishEntry("independent levels, walkers different", "" + wrong);
        assertThat(alike).isBetween(0.92, 0.98);
        assertThat(families).isBetween(0.92, 0.99);
        assertThat(different).isBetween(0.92, 0.99);
        assertThat(wrong).as("the reason why there are families").isLessThan(0.93);
    }

    private static double coverage(
            Repetitions repetitions, RuinedGambler gambler, boolean byFamilies) {
        return repetitions.share(
                random -> {
                    RuinedGambler.Outcome split = gambler.split(400, random);
                    ConfidenceInterval interval =
                            byFamilies
                                    ? split.splitting().interval(split.families(), SURE)
                                    : split.splitting().intervalOfIndependentLevels(SURE);
                    return interval.contains(gambler.probability());
                });
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
