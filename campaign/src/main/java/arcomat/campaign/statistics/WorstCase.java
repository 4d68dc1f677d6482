package arcomat.campaign.statistics;

import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.RealVector;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A search in the unit cube for the point with the smallest value: the evolution strategy CMA-ES of
 * Hansen and Ostermeier, in the form of Hansen's tutorial (arXiv 1604.00772, 2016). It asks for a
 * whole generation of points at once, which can be tried side by side; Hipparchus' own optimizer
 * asks for one after the other, so only the linear algebra is taken from there. Beyond its faces
 * the cube goes on as in a mirror. Where a search settles, or cannot tell its points apart, the
 * next one starts somewhere else, with twice as many points (Auger, Hansen: A restart CMA evolution
 * strategy with increasing population size, CEC 2005).
 *
 * <p>A value: the points follow from the seed and the values that were told, bit for bit.
 */
public final class WorstCase {
    /** Length of the first steps: most of the cube is within two of them. */
    private static final double FIRST_STEP = 0.3;

    /** Shorter steps than this find nothing new in a world: a ten-thousandth of a range. */
    private static final double LAST_STEP = 1e-4;

    private final Draws draws;
    private final int searches;
    private final int generations;
    private final SearchDistribution distribution;

    private WorstCase(Draws draws, int searches, int generations, SearchDistribution distribution) {
        this.draws = draws;
        this.searches = searches;
        this.generations = generations;
        this.distribution = distribution;
    }

    /**
     * Begins in the middle.
     *
     * @param dimension at least 1
     */
    public static WorstCase start(int dimension, long seed) {
        double[] middle = new double[dimension];
        Arrays.fill(middle, 0.5);
        return new WorstCase(
                Draws.of(seed), 1, 0, beginning(middle, SearchSettings.usualPopulation(dimension)));
    }

    private static SearchDistribution beginning(double[] mean, int population) {
        return SearchDistribution.ball(
                SearchSettings.of(mean.length, population), mean, FIRST_STEP);
    }

    /** What is to be tried now, in any order. */
    public List<double[]> points() {
        return generation().stream()
                .map(distribution::point)
                .map(point -> point.map(WorstCase::mirrored).toArray())
                .toList();
    }

    private List<RealVector> generation() {
        int dimension = distribution.settings().dimension();
        List<RealVector> generation = new ArrayList<>();
        for (int i = 0; i < distribution.settings().population(); i++) {
            Draws point = draws.part(generations).part(i);
            generation.add(
                    new ArrayRealVector(
                            IntStream.range(0, dimension)
                                    .mapToDouble(each -> point.part(each).normal())
                                    .toArray()));
        }
        return generation;
    }

    /** Into the cube, as often as it takes. */
    private static double mirrored(double coordinate) {
        double turn = coordinate - 2 * StrictMath.floor(coordinate / 2);
        return turn <= 1 ? turn : 2 - turn;
    }

    /**
     * The search after these points.
     *
     * @param values one for each of {@link #points}, in their order; not a number where a point
     *     gave none: it counts as the largest
     */
    public WorstCase next(double[] values) {
        List<RealVector> generation = generation();
        if (values.length != generation.size()) {
            throw new IllegalArgumentException(values.length + " of " + generation.size());
        }
        SearchDistribution after =
                distribution.after(
                        IntStream.range(0, values.length)
                                .boxed()
                                .sorted(Comparator.comparingDouble(i -> values[i]))
                                .map(generation::get)
                                .toList());
        return areEqual(values) || after.isOver(LAST_STEP)
                ? elsewhere()
                : new WorstCase(draws, searches, generations + 1, after);
    }

    private static boolean areEqual(double[] values) {
        return IntStream.range(1, values.length)
                .allMatch(i -> Double.compare(values[i], values[0]) == 0);
    }

    private WorstCase elsewhere() {
        Draws place = draws.part(-1L - searches);
        double[] mean =
                IntStream.range(0, distribution.settings().dimension())
                        .mapToDouble(i -> place.part(i).even())
                        .toArray();
        SearchDistribution beginning = beginning(mean, 2 * distribution.settings().population());
        return new WorstCase(draws, searches + 1, generations + 1, beginning);
    }

    /** How often it began, the first time included. */
    public int searches() {
        return searches;
    }
}
