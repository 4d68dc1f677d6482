package arcomat.campaign.statistics;

/**
 * Numbers of the CMA evolution strategy, as Hansen recommends them (The CMA evolution strategy: a
 * tutorial, arXiv 1604.00772, 2016, table 1, without negative weights). His letters stand behind
 * the names.
 *
 * @param dimension of the points (n)
 * @param population points of a generation (lambda)
 * @param weights of the best half, the best first; together they are 1 (w)
 * @param effective how many points with equal weights would be as good (mu_eff)
 * @param lengthRate how fast the path that controls the step's length forgets (c_sigma)
 * @param lengthDamping of changes of the step's length (d_sigma)
 * @param shapeRate how fast the path that shapes the step forgets (c_c)
 * @param pathRate how much the path changes the shape (c_1)
 * @param pointsRate how much the points change the shape (c_mu)
 */
record SearchSettings(
        int dimension,
        int population,
        double[] weights,
        double effective,
        double lengthRate,
        double lengthDamping,
        double shapeRate,
        double pathRate,
        double pointsRate) {
    static int usualPopulation(int dimension) {
        return 4 + (int) (3 * StrictMath.log(dimension));
    }

    static SearchSettings of(int dimension, int population) {
        double n = dimension;
        double[] weights = weights(population);
        double squares = 0;
        for (double each : weights) {
            squares += each * each;
        }
        double effective = 1 / squares;
        double lengthRate = (effective + 2) / (n + effective + 5);
        double damping =
                1 + 2 * Math.max(0, StrictMath.sqrt((effective - 1) / (n + 1)) - 1) + lengthRate;
        double shapeRate = (4 + effective / n) / (n + 4 + 2 * effective / n);
        double pathRate = 2 / ((n + 1.3) * (n + 1.3) + effective);
        double pointsRate =
                Math.min(
                        1 - pathRate,
                        2 * (effective - 2 + 1 / effective) / ((n + 2) * (n + 2) + effective));
        return new SearchSettings(
                dimension,
                population,
                weights,
                effective,
                lengthRate,
                damping,
                shapeRate,
                pathRate,
                pointsRate);
    }

    private static double[] weights(int population) {
        double[] weights = new double[population / 2];
        double sum = 0;
        for (int i = 0; i < weights.length; i++) {
            weights[i] = StrictMath.log((population + 1) / 2.0) - StrictMath.log(i + 1);
            sum += weights[i];
        }
        for (int i = 0; i < weights.length; i++) {
            weights[i] /= sum;
        }
        return weights;
    }

    /** About how long a normal draw of this dimension is (chi_n). */
    double usualLength() {
        double n = dimension;
        return StrictMath.sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n));
    }
}
