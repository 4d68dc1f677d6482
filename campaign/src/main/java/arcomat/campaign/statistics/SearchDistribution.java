package arcomat.campaign.statistics;

import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.EigenDecompositionSymmetric;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import org.hipparchus.linear.RealVector;

import java.util.List;

/**
 * The normal distribution from which a generation is drawn: equations (38) to (47) of Hansen's
 * tutorial. A value, which nobody changes.
 *
 * @param mean its middle
 * @param length of a step (sigma)
 * @param covariance the step's shape (C)
 * @param axes of the shape, as columns (B)
 * @param stretches along the axes (the diagonal of D)
 * @param lengthPath where the last steps went together, were the shape a ball (p_sigma)
 * @param shapePath where they went (p_c)
 * @param age generations since the beginning
 */
record SearchDistribution(
        SearchSettings settings,
        RealVector mean,
        double length,
        RealMatrix covariance,
        RealMatrix axes,
        RealVector stretches,
        RealVector lengthPath,
        RealVector shapePath,
        int age) {
    /** So much longer one axis may be than another before rounding spoils the shape. */
    private static final double LONGEST_AXIS = 1e7;

    static SearchDistribution ball(SearchSettings settings, double[] mean, double length) {
        RealVector nowhere = new ArrayRealVector(settings.dimension());
        RealMatrix ball = MatrixUtils.createRealIdentityMatrix(settings.dimension());
        return new SearchDistribution(
                settings,
                new ArrayRealVector(mean),
                length,
                ball,
                ball,
                nowhere.mapAdd(1),
                nowhere,
                nowhere,
                0);
    }

    /** A point, from a draw of the normal distribution that is a ball. */
    RealVector point(RealVector draw) {
        return mean.add(axes.operate(draw.ebeMultiply(stretches)).mapMultiply(length));
    }

    /**
     * After a generation.
     *
     * @param best the draws of its points, the best first
     */
    SearchDistribution after(List<RealVector> best) {
        RealVector draw = new ArrayRealVector(settings.dimension());
        for (int i = 0; i < settings.weights().length; i++) {
            draw = draw.add(best.get(i).mapMultiply(settings.weights()[i]));
        }
        RealVector step = axes.operate(draw.ebeMultiply(stretches));
        RealVector newLengthPath =
                moved(lengthPath, settings.lengthRate(), axes.operate(draw), true);
        boolean steady = isSteady(newLengthPath);
        RealVector newShapePath = moved(shapePath, settings.shapeRate(), step, steady);
        RealMatrix shape = shape(best, newShapePath, steady);
        EigenDecompositionSymmetric parts = new EigenDecompositionSymmetric(shape);
        return new SearchDistribution(
                settings,
                mean.add(step.mapMultiply(length)),
                length * lengthening(newLengthPath),
                shape,
                parts.getV(),
                new ArrayRealVector(parts.getEigenvalues())
                        .map(each -> StrictMath.sqrt(Math.max(0, each))),
                newLengthPath,
                newShapePath,
                age + 1);
    }

    private RealVector moved(RealVector path, double rate, RealVector step, boolean steady) {
        double weight = StrictMath.sqrt(rate * (2 - rate) * settings.effective());
        return path.mapMultiply(1 - rate).add(step.mapMultiply(steady ? weight : 0));
    }

    /**
     * Whether the path is not much longer than by chance: else the shape waits for the length
     * (h_sigma).
     */
    private boolean isSteady(RealVector path) {
        double forgotten = StrictMath.pow(1 - settings.lengthRate(), 2.0 * (age + 1));
        return path.getNorm() / StrictMath.sqrt(1 - forgotten)
                < (1.4 + 2.0 / (settings.dimension() + 1)) * settings.usualLength();
    }

    private double lengthening(RealVector path) {
        double excess = path.getNorm() / settings.usualLength() - 1;
        return StrictMath.exp(excess * settings.lengthRate() / settings.lengthDamping());
    }

    private RealMatrix shape(List<RealVector> best, RealVector path, boolean steady) {
        double lost = steady ? 0 : settings.shapeRate() * (2 - settings.shapeRate());
        double kept = 1 + settings.pathRate() * lost - settings.pathRate() - settings.pointsRate();
        RealMatrix shape =
                covariance
                        .scalarMultiply(kept)
                        .add(path.outerProduct(path).scalarMultiply(settings.pathRate()));
        for (int i = 0; i < settings.weights().length; i++) {
            RealVector step = axes.operate(best.get(i).ebeMultiply(stretches));
            double weight = settings.pointsRate() * settings.weights()[i];
            shape = shape.add(step.outerProduct(step).scalarMultiply(weight));
        }
        return shape.add(shape.transpose()).scalarMultiply(0.5);
    }

    /**
     * Whether nothing further is to be expected: steps are shorter than {@code least}, or a needle.
     */
    boolean isOver(double least) {
        double longest = stretches.getMaxValue();
        return !(length * longest >= least) || !(longest <= LONGEST_AXIS * stretches.getMinValue());
    }
}
