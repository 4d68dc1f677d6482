package arcomat.world.arithmetic;

/**
 * Sine and cosine, to the last bit those of {@link StrictMath}, by sums and products alone. A
 * browser may have others in the last bit, and a robot on another bit is soon in another place.
 *
 * <p>Method and coefficients: fdlibm (Sun Microsystems, 1993). An angle is taken modulo a quarter
 * turn, with a remainder of twice the precision; in there polynomials are near enough.
 */
public final class Circle {
    /** Beyond, the remainder needs more digits than are here. */
    private static final double FAR = 500_000;

    private static final double EIGHTH = bits(0x3fe921fc);
    private static final double TINY = 0x1p-27;

    private static final double[] SINE = {
        -0.16666666666666632,
        0.00833333333332249,
        -0.0001984126982985795,
        2.7557313707070068e-06,
        -2.5050760253406863e-08,
        1.58969099521155e-10
    };

    private static final double[] COSINE = {
        0.0416666666666666,
        -0.001388888888887411,
        2.480158728947673e-05,
        -2.7557314351390663e-07,
        2.087572321298175e-09,
        -1.1359647557788195e-11
    };

    private Circle() {}

    public static double radians(double degrees) {
        return degrees * 0.017453292519943295;
    }

    /**
     * An angle as the nearest one to 0, from -pi to pi: as Java's IEEEremainder by a whole turn.
     */
    public static double nearest(double angle) {
        double whole = 2 * Math.PI;
        double half = Math.PI;
        double rest = Math.abs(angle % (2 * whole));
        if (rest > half) {
            rest -= whole;
            if (rest >= half) {
                rest -= whole;
            }
        }
        return angle < 0 ? -rest : rest;
    }

    public static double sin(double angle) {
        return Math.abs(angle) < EIGHTH ? sine(angle, 0, false) : turned(angle, 0);
    }

    public static double cos(double angle) {
        return Math.abs(angle) < EIGHTH ? cosine(angle, 0) : turned(angle, 1);
    }

    /** The sine of an angle and so many quarters more. */
    private static double turned(double angle, int quarters) {
        if (!(Math.abs(angle) < FAR)) {
            return quarters == 0 ? StrictMath.sin(angle) : StrictMath.cos(angle);
        }
        QuarterTurns turns = QuarterTurns.of(angle);
        double high = turns.rest();
        double low = turns.error();
        return switch (turns.count() + quarters & 3) {
            case 0 -> sine(high, low, true);
            case 1 -> cosine(high, low);
            case 2 -> -sine(high, low, true);
            default -> -cosine(high, low);
        };
    }

    private static double sine(double x, double error, boolean hasError) {
        if (Math.abs(x) < TINY) {
            return x;
        }
        double square = x * x;
        double cube = square * x;
        double rest = polynomial(square, SINE, 1);
        return hasError
                ? x - (square * (0.5 * error - cube * rest) - error - cube * SINE[0])
                : x + cube * (SINE[0] + square * rest);
    }

    private static double cosine(double x, double error) {
        if (Math.abs(x) < TINY) {
            return 1;
        }
        double square = x * x;
        double rest = square * polynomial(square, COSINE, 0);
        double size = Math.abs(x);
        if (size < bits(0x3fd33333)) {
            return 1 - (0.5 * square - (square * rest - x * error));
        }
        double part = size >= bits(0x3fe90001) ? 0.28125 : upperHalf(size) / 4;
        double halved = 0.5 * square - part;
        return 1 - part - (halved - (square * rest - x * error));
    }

    private static double polynomial(double x, double[] coefficients, int first) {
        double sum = coefficients[coefficients.length - 1];
        for (int i = coefficients.length - 2; i >= first; i--) {
            sum = coefficients[i] + x * sum;
        }
        return sum;
    }

    /** The number whose upper 32 bits these are. */
    static double bits(int upper) {
        return Double.longBitsToDouble((long) upper << 32);
    }

    /** Without the lower 32 bits. */
    static double upperHalf(double x) {
        return Double.longBitsToDouble(Double.doubleToLongBits(x) & 0xffffffff00000000L);
    }
}
