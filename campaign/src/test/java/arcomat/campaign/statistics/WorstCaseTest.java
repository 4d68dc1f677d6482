package arcomat.campaign.statistics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;

/** The search for the worst case finds what is known to be there, sooner than chance. */
class WorstCaseTest {
    /** All values of a search, in order; whole generations, until there are {@code runs}. */
    private static List<Double> search(
            int dimension, long seed, int runs, ToDoubleFunction<double[]> value) {
        List<Double> values = new ArrayList<>();
        WorstCase search = WorstCase.start(dimension, seed);
        while (values.size() < runs) {
            double[] generation = search.points().stream().mapToDouble(value).toArray();
            Arrays.stream(generation).forEach(values::add);
            search = search.next(generation);
        }
        return values;
    }

    private static double best(List<Double> values) {
        return values.stream().min(Double::compare).orElseThrow();
    }

    /** A long narrow valley that no axis runs along, with its end away from the middle. */
    private static double valley(double[] point) {
        double across = point[0] - point[1] - 0.2;
        double along = point[0] + point[1] - 1.5;
        return 1000 * across * across + along * along;
    }

    private static double bowl(double[] point) {
        return Arrays.stream(point).map(each -> (each - 0.8) * (each - 0.8)).sum();
    }

    /** Many hollows, the deepest at 0.7 of each side (Rastrigin). */
    private static double hollows(double[] point) {
        return Arrays.stream(point)
                .map(each -> 8 * (each - 0.7))
                .map(each -> each * each + 3 * (1 - Math.cos(2 * Math.PI * each)))
                .sum();
    }

    @Test
    void findsWhatIsThere() {
        for (long seed = 0; seed < 20; seed++) {
            assertThat(best(search(1, seed, 200, WorstCaseTest::bowl))).isLessThan(1e-5);
            assertThat(best(search(2, seed, 1000, WorstCaseTest::valley))).isLessThan(1e-5);
            assertThat(best(search(5, seed, 1000, WorstCaseTest::bowl))).isLessThan(1e-5);
        }
    }

    @Test
    void isBetterThanChance() {
        double sought = 0;
        double chance = 0;
        for (long seed = 0; seed < 50; seed++) {
            long sampled = seed;
            sought += Math.log10(best(search(2, seed, 200, WorstCaseTest::valley))) / 50;
            double drawn = Double.POSITIVE_INFINITY;
            for (int i = 0; i < 200; i++) {
                double[] point = {Sampling.random(sampled, i, 0), Sampling.random(sampled, i, 1)};
                drawn = Math.min(drawn, valley(point));
            }
            chance += Math.log10(drawn) / 50;
        }
        assertThat(sought).as("log10 of the best of 200").isLessThan(chance - 1);
    }

    @Test
    void beginsAgainWhereItHasSettledInTheWrongHollow() {
        int found = 0;
        for (long seed = 0; seed < 20; seed++) {
            found += best(search(2, seed, 3000, WorstCaseTest::hollows)) < 1e-3 ? 1 : 0;
        }
        assertThat(found).as("of 20 searches").isGreaterThanOrEqualTo(18);
    }

    /** The smallest value is in a corner; all points are in the cube. */
    @Test
    void staysInTheCube() {
        List<Double> values =
                search(
                        3,
                        1,
                        600,
                        point -> {
                            assertThat(
                                            Arrays.stream(point)
                                                    .allMatch(each -> each >= 0 && each <= 1))
                                    .isTrue();
                            return point[0] + point[1] - point[2];
                        });
        assertThat(best(values)).isLessThan(-0.999);
    }

    @Test
    void isTheSameWithTheSameSeed() {
        assertThat(search(4, 5, 500, WorstCaseTest::hollows))
                .isEqualTo(search(4, 5, 500, WorstCaseTest::hollows))
                .isNotEqualTo(search(4, 6, 500, WorstCaseTest::hollows));
    }

    @Test
    void looksElsewhereWhereAllIsTheSame() {
        WorstCase search = WorstCase.start(2, 1);
        double[] same = new double[search.points().size()];
        WorstCase next = search.next(same);
        assertThat(next.searches()).isEqualTo(2);
        assertThat(next.points()).hasSize(2 * same.length);
    }

    @Test
    void aPointThatGivesNoNumberIsTheLeastInteresting() {
        List<Double> values = search(2, 3, 400, point -> point[0] > 0.9 ? Double.NaN : bowl(point));
        assertThat(values.stream().filter(each -> !each.isNaN()).min(Double::compare).orElseThrow())
                .isLessThan(1e-4);
    }
}
