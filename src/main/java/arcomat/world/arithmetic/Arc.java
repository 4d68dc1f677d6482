package arcomat.world.arithmetic;

/**
 * The angle of a direction, to the last bit that of {@link StrictMath}; see {@link Circle} for the
 * reason and for where it is from. A quotient is brought near one of four whose angle is known.
 */
public final class Arc {
    private static final double PI_ERROR = 1.2246467991473531772e-16;
    private static final double TINY = 0x1p-29;
    private static final double NEAR = 0.4375;

    private static final double[] KNOWN = {
        4.63647609000806093515e-01,
        7.85398163397448278999e-01,
        9.82793723247329054082e-01,
        1.57079632679489655800e+00
    };

    private static final double[] KNOWN_ERROR = {
        2.26987774529616870924e-17,
        3.06161699786838301793e-17,
        1.39033110312309984516e-17,
        6.12323399573676603587e-17
    };

    private static final double[] SERIES = {
        3.33333333333329318027e-01,
        -1.99999999998764832476e-01,
        1.42857142725034663711e-01,
        -1.11111104054623557880e-01,
        9.09088713343650656196e-02,
        -7.69187620504482999495e-02,
        6.66107313738753120669e-02,
        -5.83357013379057348645e-02,
        4.97687799461593236017e-02,
        -3.65315727442169155270e-02,
        1.62858201153657823623e-02
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
