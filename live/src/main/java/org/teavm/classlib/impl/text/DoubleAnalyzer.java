package org.teavm.classlib.impl.text;

import org.teavm.interop.Import;
import org.teavm.jso.core.JSString;

/** The shortest decimal digits that tell a number from all others, as the browser finds them. */
public final class DoubleAnalyzer {
    /** Of a mantissa; shorter ones are filled up with zeros. */
    public static final int DECIMAL_PRECISION = 18;

    /** The smallest mantissa but 0. */
    public static final long DOUBLE_MAX_POS = 100_000_000_000_000_000L;

    private DoubleAnalyzer() {}

    /** A number: the digit before its point, those behind it, and a power of ten. */
    public static class Result {
        public long mantissa;
        public int exponent;
        public boolean sign;
    }

    /** The whole part of the logarithm of a number that is not 0. */
    public static int fastIntLog10(double value) {
        Result result = new Result();
        analyze(value, result);
        boolean isPower = result.mantissa == DOUBLE_MAX_POS;
        return result.exponent < 0 && !isPower ? result.exponent + 1 : result.exponent;
    }

    /**
     * @param value finite
     */
    public static void analyze(double value, Result result) {
        result.sign = Double.doubleToLongBits(value) < 0;
        String text = scientific(Math.abs(value)).stringValue();
        int end = text.indexOf('e');
        result.exponent = Integer.parseInt(text.substring(end + 1));
        long unit = DOUBLE_MAX_POS;
        result.mantissa = 0;
        for (int i = 0; i < end; i++) {
            if (text.charAt(i) != '.') {
                result.mantissa += (text.charAt(i) - '0') * unit;
                unit /= 10;
            }
        }
    }

    /** Such as {@code 1.5e-7}. */
    @Import(module = "numbers", name = "scientific")
    private static native JSString scientific(double value);
}
