package arcomat.world.arithmetic;

/**
 * The exponential function below 0, to the last bit that of {@link StrictMath}; see {@link Circle}
 * for the reason and for where it is from.
 */
public final class Decay {
    private static final double HALF_LOG_2 = Circle.bits(0x3fd62e43);
    private static final double TWICE = Circle.bits(0x3ff0a2b2);
    private static final double TINY = 0x1p-28;
    private static final double LOG_2 = 0.6931471803691238;
    private static final double LOG_2_ERROR = 1.9082149292705877e-10;
    private static final double PER_LOG_2 = 1.4426950408889634;

    /** Less is no matter to anybody. */
    private static final double LEAST = -700;

    private static final double[] SERIES = {
        0.16666666666666602,
        -0.0027777777777015593,
        6.613756321437934e-05,
        -1.6533902205465252e-06,
        4.1381367970572385e-08
    };

    private Decay() {}

    /**
     * @param x at most 0
     */
    public static double exp(double x) {
        if (x < LEAST) {
            return StrictMath.exp(x);
        }
        if (-x < TINY) {
            return 1 + x;
        }
        if (-x < HALF_LOG_2) {
            double rest = rest(x);
            return 1 - (x * rest / (rest - 2) - x);
        }
        int halvings = -x < TWICE ? 1 : (int) (0.5 - PER_LOG_2 * x);
        double high = x + halvings * LOG_2;
        double low = -halvings * LOG_2_ERROR;
        double rest = rest(high - low);
        double whole = 1 - (low - (high - low) * rest / (2 - rest) - high);
        return whole * Double.longBitsToDouble((long) (1023 - halvings) << 52);
    }

    private static double rest(double x) {
        double square = x * x;
        double sum = SERIES[SERIES.length - 1];
        for (int i = SERIES.length - 2; i >= 0; i--) {
            sum = SERIES[i] + square * sum;
        }
        return x - square * sum;
    }
}
