package arcomat.campaign.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Random;

/** Tests of requirements: known values. */
class DecisionsTest {
    private static final Confidence SURE = new Confidence(0.95);

    @ParameterizedTest
    @CsvSource({
        "0,    2994, UNDECIDED",
        "0,    2995, HOLDS", // Proportion's bound is 0.00099998
        "1,    2995, UNDECIDED",
        "10,   5000, FAILS",
        "2,    2000, UNDECIDED",
        "0,    0,    UNDECIDED"
    })
    void ofAFixedNumberOfTrials(long events, long trials, Decision expected) {
        FixedTest test = new FixedTest(0.001, SURE);
        assertThat(test.decide(new Proportion(events, trials))).isEqualTo(expected);
    }

    @Test
    void withoutAnyEventItHoldsAfterTheLeastTrials() {
        SequentialTest test = SequentialTest.below(0.001, SURE);
        SequentialCourse course = test.start();
        for (int i = 0; i < 10_000; i++) {
            course.see(false);
        }
        assertThat(course.decision()).isEqualTo(Decision.HOLDS);
        assertThat(course.trials()).isEqualTo(test.leastTrials()).isEqualTo(5990);
        assertThat(course.see(true)).as("it is decided").isEqualTo(Decision.HOLDS);
        assertThat(course.events()).isZero();
    }

    /** ln 0.05 / ln 0.4995 is more than 4: the fifth event in a row is one too many. */
    @Test
    void ofManyEventsItFailsSoon() {
        SequentialCourse course = SequentialTest.below(0.001, SURE).start();
        for (int i = 0; i < 4; i++) {
            assertThat(course.see(true)).isEqualTo(Decision.UNDECIDED);
        }
        assertThat(course.see(true)).isEqualTo(Decision.FAILS);
        assertThat(course.trials()).isEqualTo(5);
    }

    private static SequentialCourse course(Random random, SequentialTest test, double truth) {
        SequentialCourse course = test.start();
        while (course.decision() == Decision.UNDECIDED) {
            course.see(random.nextDouble() < truth);
        }
        return course;
    }

    @Test
    void theHardestTakesAboutAsLongAsSaid() {
        SequentialTest test = SequentialTest.below(0.05, SURE);
        Random random = new Random(17);
        double trials = 0;
        for (int i = 0; i < 2000; i++) {
            trials += course(random, test, 0.0361).trials() / 2000.0;
        }
        assertThat(trials / test.trialsOfTheHardest()).isBetween(0.9, 1.3);
    }

    @ParameterizedTest
    @CsvSource({"0.01, 0.95, 18445", "0.001, 0.95, 1844440", "0.05, 0.99, 1060"})
    void okamotosBound(double error, double confidence, long trials) {
        assertThat(SampleSize.forError(error, new Confidence(confidence))).isEqualTo(trials);
    }

    @ParameterizedTest
    @CsvSource({
        "0.1,   0.95, 29", // "rule of three": Hanley, Lippman-Hand, JAMA 249, 1983
        "0.001, 0.95, 2995",
        "1e-6,  0.95, 2995731",
        "0.001, 0.99, 4603"
    })
    void runsWithoutEvents(double bound, double confidence, long trials) {
        Confidence sure = new Confidence(confidence);
        assertThat(SampleSize.withoutEvents(bound, sure)).isEqualTo(trials);
        assertThat(new Proportion(0, trials).atMost(sure)).isLessThanOrEqualTo(bound);
        assertThat(new Proportion(0, trials - 1).atMost(sure)).isGreaterThan(bound);
    }

    /**
     * The second line: table 1 of Fagerland, Lydersen, Laake, BMC Medical Research Methodology 13,
     * 2013.
     */
    @ParameterizedTest
    @CsvSource({
        "2,  10,  0.03857421875, 0.019287109375, 0.996826171875",
        "1,  7,   0.0703125,     0.03515625,     0.99609375",
        "4,  4,   1,             0.63671875,     0.63671875",
        "0,  0,   1,             1,              1"
    })
    void mcNemar(long better, long worse, double difference, double worsening, double improvement) {
        McNemar test = new McNemar(better, worse);
        assertThat(test.difference()).isCloseTo(difference, within(1e-12));
        assertThat(test.worsening()).isCloseTo(worsening, within(1e-12));
        assertThat(test.improvement()).isCloseTo(improvement, within(1e-12));
    }
}
