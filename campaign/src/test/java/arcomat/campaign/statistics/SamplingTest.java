package arcomat.campaign.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

import org.junit.jupiter.api.Test;

import java.util.BitSet;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.LongStream;

/** Points are spread as they should be, and each can be had alone. */
class SamplingTest {
    @Property(tries = 100)
    void aLatinHypercubeHitsEachPartOnce(
            @ForAll long seed,
            @ForAll @IntRange(min = 1, max = 300) int total,
            @ForAll @IntRange(max = 20) int dimension) {
        BitSet hit = new BitSet();
        for (int number = 0; number < total; number++) {
            double value = Sampling.latin(seed, number, dimension, total);
            int part = part(value, total);
            assertThat(hit.get(part)).isFalse();
            hit.set(part);
        }
        assertThat(hit.cardinality()).isEqualTo(total);
        assertThat(hit.length()).isEqualTo(total);
    }

    /** The last part that begins before the value, or with it. */
    private static int part(double value, int total) {
        assertThat(value).isBetween(0.0, Math.nextDown(1.0));
        int part = (int) (value * total);
        return (double) (part + 1) / total <= value ? part + 1 : part;
    }

    /** Every number goes everywhere, as often as anywhere else. */
    @Test
    void shufflesAreEven() {
        int shuffles = 6_000;
        for (int size : new int[] {2, 3, 5, 8}) {
            for (int number = 0; number < size; number++) {
                int first = number;
                Map<Long, Long> places =
                        LongStream.range(0, shuffles)
                                .mapToObj(seed -> new Shuffle(Draws.of(seed), size).place(first))
                                .collect(
                                        Collectors.groupingBy(
                                                Function.identity(), Collectors.counting()));
                double share = 1.0 / size;
                assertThat(places).hasSize(size);
                assertThat(places.values())
                        .allSatisfy(
                                times ->
                                        assertThat((double) times / shuffles)
                                                .isCloseTo(share, within(0.03)));
            }
        }
    }

    @Test
    void allOrdersOfThreeAreAsLikely() {
        Map<String, Long> orders =
                LongStream.range(0, 12_000)
                        .mapToObj(seed -> new Shuffle(Draws.of(seed), 3))
                        .collect(
                                Collectors.groupingBy(
                                        each -> "" + each.place(0) + each.place(1) + each.place(2),
                                        Collectors.counting()));
        assertThat(orders).hasSize(6);
        assertThat(orders.values()).allSatisfy(times -> assertThat(times).isBetween(1800L, 2200L));
    }

    @Test
    void randomPointsAreEvenAndKnowNothingOfEachOther() {
        int points = 20_000;
        double sum = 0;
        double product = 0;
        double successive = 0;
        for (int number = 0; number < points; number++) {
            double x = Sampling.random(7, number, 0) - 0.5;
            sum += x;
            product += x * (Sampling.random(7, number, 1) - 0.5);
            successive += x * (Sampling.random(7, number + 1, 0) - 0.5);
        }
        // Deviations of the means: 0.002 and 0.0006.
        assertThat(sum / points).isCloseTo(0, within(0.008));
        assertThat(product / points).isCloseTo(0, within(0.0024));
        assertThat(successive / points).isCloseTo(0, within(0.0024));
    }

    /** A latin sample tells the mean of a sum far better than a random one of as many points. */
    @Test
    void aLatinHypercubeIsSpreadBetter() {
        double latin = 0;
        double random = 0;
        for (long seed = 0; seed < 100; seed++) {
            double ofLatin = 0;
            double ofRandom = 0;
            for (int number = 0; number < 100; number++) {
                ofLatin +=
                        Sampling.latin(seed, number, 0, 100)
                                + Sampling.latin(seed, number, 1, 100)
                                - 1;
                ofRandom += Sampling.random(seed, number, 0) + Sampling.random(seed, number, 1) - 1;
            }
            latin += ofLatin * ofLatin;
            random += ofRandom * ofRandom;
        }
        assertThat(latin).isLessThan(random / 1000);
    }

    /** The same ones tomorrow, and on another machine. */
    @Test
    void drawsAreWhatTheyWere() {
        assertThat(Sampling.random(1, 0, 0)).isEqualTo(0.14141552312985728);
        assertThat(Sampling.latin(1, 999_999, 3, 1_000_000)).isEqualTo(0.5071518206018268);
    }
}
