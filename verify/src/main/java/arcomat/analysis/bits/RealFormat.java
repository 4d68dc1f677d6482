package arcomat.analysis.bits;

import arcomat.model.Type;

/**
 * Numbers of floating point as IEEE 754 lays them out: from the last bit on a fraction, an exponent
 * and a sign. What is no number has one pattern, since models have one such message.
 *
 * @param single whether they have 32 bits
 */
public record RealFormat(int exponentWidth, int fractionWidth, boolean single) {
    private static final RealFormat DOUBLE = new RealFormat(11, 52, false);
    private static final RealFormat SINGLE = new RealFormat(8, 23, true);

    public static RealFormat of(Type.RealType type) {
        return type.single() ? SINGLE : DOUBLE;
    }

    int width() {
        return 1 + exponentWidth + fractionWidth;
    }

    /** The exponent of numbers from 1 to 2. */
    int bias() {
        return (1 << exponentWidth - 1) - 1;
    }

    /** The exponent of what is infinite, and of what is no number. */
    int beyond() {
        return (1 << exponentWidth) - 1;
    }

    public long infinity() {
        return (long) beyond() << fractionWidth;
    }

    long notANumber() {
        return infinity() | 1L << fractionWidth - 1;
    }

    /** The pattern of a number that the type has. */
    long code(double number) {
        if (Double.isNaN(number)) {
            return notANumber();
        }
        return single
                ? Float.floatToRawIntBits((float) number)
                : Double.doubleToRawLongBits(number);
    }

    double real(long code) {
        return single ? Float.intBitsToFloat((int) code) : Double.longBitsToDouble(code);
    }

    /**
     * Where a number stands among all of them, which are as many: the positive ones by their
     * patterns, the negative ones as the opposite; there is one 0.
     */
    public long place(double number) {
        long size = code(Math.abs(number));
        return number < 0 ? -size : size;
    }

    /** The number at a place. */
    public double atPlace(long place) {
        double size = real(Math.abs(place));
        return place < 0 ? -size : size;
    }
}
