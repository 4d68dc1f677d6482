package arcomat.world.arithmetic;

/**
 * The angle of a direction, to the last bit that of {@link StrictMath}; see {@link Circle} for the
 * reason and for where it is from. A quotient is brought near one of four whose angle is known.
 */
public final class Arc {
    private static final double PI_ERROR = 1.2246467991473532e-16;
    private static final double TINY = 0x1p-29;
    private static final double NEAR = 0.4375;

    private static final double[] KNOWN = {
        0.4636476090008061, 0.7853981633974483, 0.982793723247329, 1.5707963267948966
    };

    private static final double[] KNOWN_ERROR = {
        2.2698777452961687e-17, 3.061616997868383e-17, 1.3903311031230998e-17, 6.123233995736766e-17
    };

    private static final double[] SERIES = {
        0.3333333333333293,
        -0.19999999999876483,
        0.14285714272503466,
        -0.11111110405462356,
        0.09090887133436507,
        -0.0769187620504483,
        0.06661073137387531,
        -0.058335701337905735,
        0.049768779946159324,
        -0.036531572744216916,
        0.016285820115365782
    };

    private Arc() {}

    /** From -pi to pi; 0 along x. Places on a floor are neither infinite nor next to nothing. */
    public static double atan2(double y, double x) {
        if (y == 0 || x == 0) {
            return StrictMath.atan2(y, x); // exact, and no matter of the last bit
        }
        double angle = atan(Math.abs(y / x));
        if (x > 0) {
            return y > 0 ? angle : -angle;
        }
        double opposite = angle - PI_ERROR;
        return y > 0 ? Math.PI - opposite : opposite - Math.PI;
    }

    private static double atan(double x) {
        if (x < TINY) {
            return x;
        }
        if (x < NEAR) {
            return x - x * series(x);
        }
        if (x < 1.1875) {
            return x < 0.6875 ? behind(0, (2 * x - 1) / (2 + x)) : behind(1, (x - 1) / (x + 1));
        }
        return x < 2.4375 ? behind(2, (x - 1.5) / (1 + 1.5 * x)) : behind(3, -1 / x);
    }

    private static double behind(int known, double x) {
        return KNOWN[known] - (x * series(x) - KNOWN_ERROR[known] - x);
    }

    private static double series(double x) {
        double square = x * x;
        double fourth = square * square;
        return square * everySecond(fourth, 10) + fourth * everySecond(fourth, 9);
    }

    private static double everySecond(double x, int last) {
        double sum = SERIES[last];
        for (int i = last - 2; i >= 0; i -= 2) {
            sum = SERIES[i] + x * sum;
        }
        return sum;
    }
}
