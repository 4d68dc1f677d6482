package arcomat.rt;

/**
 * Operations of models that can go wrong. Each returns its result or throws a {@link ModelError}
 * that says where: generated code must not rely on {@code ArithmeticException}, which is a checked
 * exception on the brick.
 */
public final class Check {
    /** The first whole number that is too large for a long. */
    private static final double BEYOND = 9223372036854775808.0;

    private Check() {}

    /** The value, if it lies between low and high, both included. */
    public static int range(int value, int low, int high, String place) {
        return value < low || value > high
                ? (int) outside(value, "Integer", low, high, place)
                : value;
    }

    /** The value, if it lies between low and high, both included. */
    public static long range(long value, long low, long high, String place) {
        return value < low || value > high ? outside(value, "Long", low, high, place) : value;
    }

    /** Like {@link #range(int, int, int, String)}, for a range of type short. */
    public static int shortRange(int value, int low, int high, String place) {
        return value < low || value > high
                ? (int) outside(value, "short", low, high, place)
                : value;
    }

    /** Like {@link #range(int, int, int, String)}, for a range of type byte. */
    public static int byteRange(int value, int low, int high, String place) {
        return value < low || value > high ? (int) outside(value, "byte", low, high, place) : value;
    }

    private static long outside(long value, String type, long low, long high, String place) {
        throw new ModelError(
                place + " = " + value + " is outside " + type + "[" + low + ".." + high + "]");
    }

    /** Java's quotient. */
    public static int divide(int dividend, int divisor, String place) {
        if (divisor == 0) {
            throw byZero(place);
        }
        return dividend / divisor;
    }

    /** Java's quotient. */
    public static long divide(long dividend, long divisor, String place) {
        if (divisor == 0) {
            throw byZero(place);
        }
        return dividend / divisor;
    }

    /** Java's remainder. */
    public static int remainder(int dividend, int divisor, String place) {
        if (divisor == 0) {
            throw byZero(place);
        }
        return dividend % divisor;
    }

    /** Java's remainder. */
    public static long remainder(long dividend, long divisor, String place) {
        if (divisor == 0) {
            throw byZero(place);
        }
        return dividend % divisor;
    }

    /** Java's conversion: the brick makes something else of a number beyond 64 bits. */
    public static long truncate(double number) {
        if (number >= BEYOND) {
            return Long.MAX_VALUE;
        }
        if (number <= -BEYOND) {
            return Long.MIN_VALUE;
        }
        return number != number ? 0 : (long) number;
    }

    static ModelError byZero(String place) {
        return new ModelError(place + ": division by zero");
    }
}
