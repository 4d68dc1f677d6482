package arcomat.world.arithmetic;

/**
 * The exponential function below 0, to the last bit that of {@link StrictMath}; see {@link Circle}
 * for the reason and for where it is from.
 */
public final class Decay {
    private static final double HALF_LOG_2 = Circle.bits(0x3fd62e43);
    private static final double TWICE = Circle.bits(0x3ff0a2b2);
    private static final double TINY = 0x1p-28;
    private static final double LOG_2 = 6.93147180369123816490e-01;
    private static final double LOG_2_ERROR = 1.90821492927058770002e-10;
    private static final double PER_LOG_2 = 1.44269504088896338700e+00;

    /** Less is no matter to anybody. */
    private static final double LEAST = -700;

    private static final double[] SERIES = {
        1.66666666666666019037e-01,
        -2.77777777770155933842e-03,
        6.61375632143793436117e-05,
        -1.65339022054652515390e-06,
        4.13813679705723846039e-08
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
