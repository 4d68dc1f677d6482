package arcomat.world.arithmetic;

/**
 * The tangent, to the last bit that of {@link StrictMath}; see {@link Circle} for the reason and
 * for where it is from.
 */
public final class Tangent {
    private static final double EIGHTH = 0.7853981633974483;
    private static final double EIGHTH_ERROR = 3.061616997868383e-17;
    private static final double AT_MOST_EIGHTH = Circle.bits(0x3fe921fc);
    private static final double NEAR_EIGHTH = Circle.bits(0x3fe59428);
    private static final double TINY = 0x1p-28;

    private static final double[] SERIES = {
        0.3333333333333341,
        0.13333333333320124,
        0.05396825397622605,
        0.021869488294859542,
        0.0088632398235993,
        0.0035920791075913124,
        0.0014562094543252903,
        0.0005880412408202641,
        0.0002464631348184699,
        7.817944429395571e-05,
        7.140724913826082e-05,
        -1.8558637485527546e-05,
        2.590730518636337e-05
    };

    private Tangent() {}

    /**
     * @param angle not farther than some turns
     */
    public static double tan(double angle) {
        if (Math.abs(angle) < AT_MOST_EIGHTH) {
            return of(angle, 0, false);
        }
        QuarterTurns turns = QuarterTurns.of(angle);
        return of(turns.rest(), turns.error(), (turns.count() & 1) != 0);
    }

    /** Of at most an eighth of a turn; or of a quarter more. */
    private static double of(double x, double error, boolean turned) {
        if (Math.abs(x) < TINY) {
            return turned ? reciprocal(x, error) : x;
        }
        if (Math.abs(x) < NEAR_EIGHTH) {
            double rest = rest(x, error);
            return turned ? reciprocal(x, rest) : x + rest;
        }
        double sign = Math.signum(x);
        double left = EIGHTH - sign * x + (EIGHTH_ERROR - sign * error);
        double rest = rest(left, 0);
        double sum = left + rest;
        double way = turned ? -1 : 1;
        return sign * (way - 2 * (left - (sum * sum / (sum + way) - rest)));
    }

    /** What the tangent is more than its argument. */
    private static double rest(double x, double error) {
        double square = x * x;
        double fourth = square * square;
        double cube = square * x;
        double sum = everySecond(fourth, 11) + square * everySecond(fourth, 12);
        return error + square * (cube * sum + error) + SERIES[0] * cube;
    }

    private static double everySecond(double x, int last) {
        double sum = SERIES[last];
        for (int i = last - 2; i >= 1; i -= 2) {
            sum = SERIES[i] + x * sum;
        }
        return sum;
    }

    /** -1 by the sum, with more digits than a division has. */
    private static double reciprocal(double x, double rest) {
        double sum = x + rest;
        double upper = Circle.upperHalf(sum);
        double lower = rest - (upper - x);
        double quotient = -1 / sum;
        double shortened = Circle.upperHalf(quotient);
        return shortened + quotient * (1 + shortened * upper + shortened * lower);
    }
}
