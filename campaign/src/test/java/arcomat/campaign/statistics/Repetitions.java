package arcomat.campaign.statistics;

import java.util.SplittableRandom;
import java.util.function.Predicate;
import java.util.random.RandomGenerator;

/**
 * The same experiment many times, each with chances of its own; the same ones in every run of a
 * test.
 */
record Repetitions(int count, long seed) {
    /** How often something was so. */
    double share(Predicate<RandomGenerator> experiment) {
        RandomGenerator random = new SplittableRandom(seed);
        int so = 0;
        for (int i = 0; i < count; i++) {
            so += experiment.test(random) ? 1 : 0;
        }
        return (double) so / count;
    }

    /**
     * By how much a share may be beyond its limit, because so few repetitions are no more exact:
     * four standard deviations, which chance exceeds once in 30,000 tests.
     */
    double allowance(double limit) {
        return 4 * Math.sqrt(limit * (1 - limit) / count);
    }

    static long events(RandomGenerator random, int trials, double probability) {
        long events = 0;
        for (int i = 0; i < trials; i++) {
            events += random.nextDouble() < probability ? 1 : 0;
        }
        return events;
    }
}
