package arcomat.campaign.statistics;

/**
 * Points of the unit cube that are tried. Each coordinate of each point is a function of the seed
 * and of its numbers: nobody has to compute the points before it.
 */
public final class Sampling {
    private static final long ORDER = 0;
    private static final long PLACE = 1;

    private Sampling() {}

    /**
     * A coordinate of a point that is as likely here as there.
     *
     * @param number of the point, from 0
     * @param dimension number of the coordinate, from 0
     * @return from 0 to 1, the end excluded
     */
    public static double random(long seed, long number, int dimension) {
        return Draws.of(seed).part(dimension).part(PLACE).part(number).even();
    }

    /**
     * A coordinate of a point of a Latin hypercube: where a side is cut in {@code total} equal
     * parts, each part has one of the points (McKay, Beckman, Conover: A comparison of three
     * methods for selecting values of input variables, Technometrics 21, 1979).
     *
     * @param number of the point, from 0, less than {@code total}
     * @param dimension number of the coordinate, from 0
     * @param total how many points there are
     * @return from 0 to 1, the end excluded
     */
    public static double latin(long seed, long number, int dimension, long total) {
        Draws order = Draws.of(seed).part(dimension).part(ORDER);
        long part = new Shuffle(order, total).place(number);
        double value = (part + random(seed, number, dimension)) / total;
        // Rounding may not carry it into the next part.
        return Math.min(value, Math.nextDown((part + 1.0) / total));
    }
}
