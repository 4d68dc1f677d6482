package arcomat.analysis.bits;

import arcomat.model.Type;

/**
 * Numbers of floating point as IEEE 754 lays them out: from the last bit on a fraction, an exponent
 * and a sign. What is no number has one pattern, since models have one such message.
 */
record RealFormat(int exponentWidth, int fractionWidth, boolean single) {
    private static final RealFormat DOUBLE = new RealFormat(11, 52, false);
    private static final RealFormat SINGLE = new RealFormat(8, 23, true);

    static RealFormat of(Type.RealType type) {
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

    long infinity() {
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
}
