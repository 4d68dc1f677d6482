package arcomat.campaign.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.hipparchus.stat.interval.BinomialProportion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Intervals for probabilities: known values. */
class ProportionTest {
    private static final Confidence SURE = new Confidence(0.95);

    /**
     * Newcombe: Two-sided confidence intervals for the single proportion, Statistics in Medicine
     * 17, 1998, table I, methods 3 (score, without continuity correction) and 5 (Clopper-Pearson).
     */
    @ParameterizedTest
    @CsvSource({
        "81, 263, 0.2553, 0.3662, 0.2527, 0.3676",
        "15, 148, 0.0624, 0.1605, 0.0578, 0.1617",
        "0,  20,  0.0000, 0.1611, 0.0000, 0.1684",
        "1,  29,  0.0061, 0.1718, 0.0009, 0.1776",
    })
    void areThoseOfNewcombesTable(
            long events, long trials, double low, double high, double exactLow, double exactHigh) {
        Proportion seen = new Proportion(events, trials);
        assertThat(seen.wilson(SURE).low()).isCloseTo(low, within(0.00005));
        assertThat(seen.wilson(SURE).high()).isCloseTo(high, within(0.00005));
        assertThat(seen.exact(SURE).low()).isCloseTo(exactLow, within(0.00005));
        assertThat(seen.exact(SURE).high()).isCloseTo(exactHigh, within(0.00005));
    }

    @Test
    void aThousandGoodRunsShowLittle() {
        Proportion good = new Proportion(0, 1000);
        assertThat(good.atMost(SURE)).isCloseTo(0.0029912, within(5e-8));
        assertThat(good.exact(SURE).high()).isCloseTo(0.0036821, within(5e-8));
        assertThat(good.exact(SURE).low()).isZero();
    }

    /** Where nothing happened there is a formula. */
    @ParameterizedTest
    @CsvSource({"1", "10", "1000", "3000000", "1000000000"})
    void boundsAreRightForManyTrials(long trials) {
        double bound = -Math.expm1(Math.log(0.05) / trials);
        assertThat(new Proportion(0, trials).atMost(SURE) / bound).isCloseTo(1, within(1e-6));
        assertThat(new Proportion(trials, trials).atLeast(SURE)).isCloseTo(1 - bound, within(1e-9));
    }

    @Test
    void aBoundIsWhereWhatWasSeenGetsUnlikely() {
        Proportion seen = new Proportion(1_234_567, 1_000_000_000);
        assertThat(new Binomial(seen.trials(), seen.atMost(SURE)).atMost(seen.events()))
                .isCloseTo(0.05, within(1e-4));
        assertThat(new Binomial(seen.trials(), seen.atLeast(SURE)).atLeast(seen.events()))
                .isCloseTo(0.05, within(1e-4));
    }

    @Test
    void nothingIsKnownBeforeTheFirstTrial() {
        Proportion nothing = new Proportion(0, 0);
        assertThat(nothing.exact(SURE)).isEqualTo(new ConfidenceInterval(0, 1));
        assertThat(nothing.wilson(SURE)).isEqualTo(new ConfidenceInterval(0, 1));
    }

    /** Those of a library, by other formulas. */
    @Test
    void areThoseOfHipparchus() {
        for (int events = 1; events < 40; events++) {
            Proportion seen = new Proportion(events, 40);
            double share = seen.estimate();
            var exact = BinomialProportion.getClopperPearsonInterval(40, share, 0.95);
            var wilson = BinomialProportion.getWilsonScoreInterval(40, share, 0.95);
            assertThat(seen.exact(SURE).low()).isCloseTo(exact.getLowerBound(), within(1e-7));
            assertThat(seen.exact(SURE).high()).isCloseTo(exact.getUpperBound(), within(1e-7));
            assertThat(seen.wilson(SURE).low()).isCloseTo(wilson.getLowerBound(), within(1e-12));
            assertThat(seen.wilson(SURE).high()).isCloseTo(wilson.getUpperBound(), within(1e-12));
        }
    }
}
