package arcomat.campaign.statistics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.random.RandomGenerator;
import java.util.stream.DoubleStream;

/**
 * How often intervals and tests are right where the truth is known, by doing it thousands of times.
 * The page on statistics shows what comes out; {@code -Dtranscripts.update=true} writes it.
 */
class MeasuredPromisesTest {
    private static final Path PAGE = Path.of("docs/statistics.md");
    private static final Confidence SURE = new Confidence(0.95);
    private static final int MANY = 4000;
    private static final int SOME = 500;

    /** A share that is promised to lie between two numbers. */
    private record Promise(String said, double low, double high) {
        static final Promise RIGHT = new Promise("at least 0.95", 0.95, 1);
        static final Promise ABOUT = new Promise("about 0.95", 0.94, 0.98);
        static final Promise NONE = new Promise("nothing here", 0, 0.93);
        static final Promise WRONG = new Promise("at most 0.05", 0, 0.05);

        void assertKept(Repetitions repetitions, double share, String of) {
            assertThat(share)
                    .as(of)
                    .isBetween(
                            low - repetitions.allowance(low), high + repetitions.allowance(high));
        }
    }

    private record Row(
            String what, Promise promise, int repetitions, Predicate<RandomGenerator> experiment) {
        String measured() {
            Repetitions all = new Repetitions(repetitions, 14);
            double share = all.share(experiment);
            promise.assertKept(all, share, what);
            return String.format(
                    Locale.ROOT,
                    "| %s | %s | %.3f | %,d |",
                    what,
                    promise.said(),
                    share,
                    repetitions);
        }
    }

    private final List<Row> rows = new ArrayList<>();

    @Tag("slow")
    @Test
    void areKept() throws IOException {
        proportions();
        quantiles();
        fixedTests();
        sequentialTests();
        splittings();
        new PageTable(PAGE, "| statement at 95 % | promised | measured | repetitions |")
                .assertRows(rows.stream().map(Row::measured).toList());
    }

    private void proportions() {
        for (double truth : new double[] {0.5, 0.1, 0.01, 0.002}) {
            proportion("Clopper-Pearson", Promise.RIGHT, truth, Proportion::exact);
            proportion("upper bound", Promise.RIGHT, truth, MeasuredPromisesTest::bounded);
            proportion("Wilson", Promise.ABOUT, truth, Proportion::wilson);
        }
    }

    private static ConfidenceInterval bounded(Proportion seen, Confidence confidence) {
        return new ConfidenceInterval(0, seen.atMost(confidence));
    }

    private void proportion(
            String name,
            Promise promise,
            double truth,
            BiFunction<Proportion, Confidence, ConfidenceInterval> interval) {
        int trials = 1000;
        ConfidenceInterval[] known = new ConfidenceInterval[trials + 1];
        for (int events = 0; events <= trials; events++) {
            known[events] = interval.apply(new Proportion(events, trials), SURE);
        }
        rows.add(
                new Row(
                        "%s, p = %s, %d trials".formatted(name, truth, trials),
                        promise,
                        MANY,
                        random ->
                                known[(int) Repetitions.events(random, trials, truth)].contains(
                                        truth)));
    }

    private void quantiles() {
        quantile("0.5 of dice", 0.5, 3, random -> 1 + random.nextInt(6));
        quantile("0.9 of even numbers", 0.9, 0.9, RandomGenerator::nextDouble);
        quantile(
                "0.95 of times, one of twelve endless",
                0.95,
                Double.POSITIVE_INFINITY,
                MeasuredPromisesTest::arrival);
    }

    /** Seconds; one of twelve does not arrive. */
    private static double arrival(RandomGenerator random) {
        return random.nextInt(12) == 0 ? Double.POSITIVE_INFINITY : 10 + random.nextDouble();
    }

    private void quantile(
            String name, double share, double truth, ToDoubleFunction<RandomGenerator> measure) {
        rows.add(
                new Row(
                        "quantile %s, 120 runs".formatted(name),
                        Promise.RIGHT,
                        SOME,
                        random -> quantile(share, measure, random).contains(truth)));
    }

    private static ConfidenceInterval quantile(
            double share, ToDoubleFunction<RandomGenerator> measure, RandomGenerator random) {
        double[] values =
                DoubleStream.generate(() -> measure.applyAsDouble(random)).limit(120).toArray();
        return new Quantile(share).interval(Measurements.of(() -> Arrays.stream(values)), SURE);
    }

    /** Just beyond the bound it is a fault to say that it holds, at the bound that it fails. */
    private void fixedTests() {
        fixedTest(Decision.HOLDS, 0.0501);
        fixedTest(Decision.FAILS, 0.05);
    }

    private void fixedTest(Decision wrong, double truth) {
        FixedTest test = new FixedTest(0.05, SURE);
        rows.add(
                new Row(
                        "fixed, p <= 0.05: %s, though p = %s, 1000 trials".formatted(wrong, truth),
                        Promise.WRONG,
                        MANY,
                        random -> {
                            long events = Repetitions.events(random, 1000, truth);
                            return test.decide(new Proportion(events, 1000)) == wrong;
                        }));
    }

    private void sequentialTests() {
        for (double bound : new double[] {0.9, 0.5, 0.05, 0.01}) {
            SequentialTest test = SequentialTest.below(bound, SURE);
            sequentialTest(test, bound, Decision.HOLDS);
            sequentialTest(test, test.near(), Decision.FAILS);
        }
        sequentialTest(SequentialTest.below(0.05, SURE), 0.06, Decision.HOLDS);
        sequentialTest(SequentialTest.below(0.05, SURE), 0.02, Decision.FAILS);
    }

    private void sequentialTest(SequentialTest test, double truth, Decision wrong) {
        rows.add(
                new Row(
                        String.format(
                                Locale.ROOT,
                                "sequential, p < %s: %s, though p = %.4f",
                                test.bound(),
                                wrong,
                                truth),
                        Promise.WRONG,
                        MANY / 2,
                        random -> decision(test, truth, random) == wrong));
    }

    private static Decision decision(SequentialTest test, double truth, RandomGenerator random) {
        SequentialCourse course = test.start();
        while (course.decision() == Decision.UNDECIDED) {
            course.see(random.nextDouble() < truth);
        }
        return course.decision();
    }

    private void splittings() {
        RuinedGambler alike = new RuinedGambler(List.of(0.4), 15);
        RuinedGambler different = new RuinedGambler(List.of(0.45, 0.3), 15);
        splitting("families, walkers alike", Promise.ABOUT, alike, true);
        splitting("families, walkers different", Promise.ABOUT, different, true);
        splitting("independent levels, walkers alike", Promise.ABOUT, alike, false);
        splitting("independent levels, walkers different", Promise.NONE, different, false);
    }

    private void splitting(
            String name, Promise promise, RuinedGambler gambler, boolean byFamilies) {
        double truth = gambler.probability();
        rows.add(
                new Row(
                        String.format(Locale.ROOT, "splitting, %s, p = %.5f", name, truth),
                        promise,
                        SOME,
                        random ->
                                interval(gambler.split(300, random), byFamilies).contains(truth)));
    }

    private static ConfidenceInterval interval(RuinedGambler.Outcome split, boolean byFamilies) {
        return byFamilies
                ? split.splitting().interval(split.families(), SURE)
                : split.splitting().intervalOfIndependentLevels(SURE);
    }

    /**
     * Where both are feasible, splitting and brute force agree with each other and with the truth.
     */
    @Test
    void splittingAgreesWithBruteForce() throws IOException {
        new PageTable(PAGE, "| p | brute force | trials | splitting | trials |")
                .assertRows(List.of(compared(15, 500_000), compared(21, 1_500_000)));
    }

    private static String compared(int goal, int walks) {
        RuinedGambler gambler = new RuinedGambler(List.of(0.4), goal);
        RandomGenerator random = new SplittableRandom(20);
        long wins = 0;
        for (int i = 0; i < walks; i++) {
            wins += gambler.wins(random) ? 1 : 0;
        }
        ConfidenceInterval brute = new Proportion(wins, walks).exact(SURE);
        Splitting split = gambler.split(5000, random).splitting();
        ConfidenceInterval interval = split.intervalOfIndependentLevels(SURE);
        assertThat(brute.contains(gambler.probability())).isTrue();
        assertThat(interval.contains(gambler.probability())).isTrue();
        assertThat(interval.low()).isLessThan(brute.high());
        assertThat(brute.low()).isLessThan(interval.high());
        return String.format(
                Locale.ROOT,
                "| %.4g | %.4g to %.4g | %,d | %.4g to %.4g | %,d |",
                gambler.probability(),
                brute.low(),
                brute.high(),
                walks,
                interval.low(),
                interval.high(),
                split.levels().stream().mapToLong(Splitting.Level::started).sum());
    }

    @Test
    void theNumbersOfTrialsAreThose() throws IOException {
        List<String> trials = new ArrayList<>();
        for (String written : "0.1 0.01 0.001 0.0001 0.00001 0.000001".split(" ")) {
            double bound = Double.parseDouble(written);
            SequentialTest test = SequentialTest.below(bound, SURE);
            trials.add(
                    String.format(
                            Locale.ROOT,
                            "| %s | %,d | %,d | %,d |",
                            written,
                            SampleSize.withoutEvents(bound, SURE),
                            test.leastTrials(),
                            test.trialsOfTheHardest()));
        }
        new PageTable(
                        PAGE,
                        "| bound | fixed, no event | sequential, no event | sequential, hardest |")
                .assertRows(trials);
    }
}
