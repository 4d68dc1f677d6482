package org.teavm.classlib.impl.text;

import org.teavm.interop.Import;
import org.teavm.jso.core.JSString;

/** The number that is nearest to some decimal digits, as the browser finds it. */
public final class DoubleSynthesizer {
    /** Digits of a mantissa behind its point. */
    private static final int FRACTION = 18;

    private DoubleSynthesizer() {}

    /**
     * @param mantissa digits, without a sign: one before the point
     * @param exponent power of ten
     */
    public static double synthesizeDouble(long mantissa, int exponent, boolean isNegative) {
        String digits = Long.toUnsignedString(mantissa);
        double size = nearest(JSString.valueOf(digits + "e" + (exponent - FRACTION)));
        return isNegative ? -size : size;
    }

    @Import(module = "numbers", name = "nearest")
    private static native double nearest(JSString text);
}
