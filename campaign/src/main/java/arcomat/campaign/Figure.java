package arcomat.campaign;

import java.math.BigDecimal;
import java.math.MathContext;

/** Numbers as people read them. */
public final class Figure {
    private static final MathContext DIGITS = new MathContext(3);
    private static final double LARGE = 1e9;

    private Figure() {}

    /**
     * With three digits that say something, but all of a whole number.
     *
     * @param value a finite number
     */
    public static String text(double value) {
        return value == Math.rint(value) && Math.abs(value) < LARGE
                ? Long.toString((long) value)
                : new BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString();
    }

    static String percent(double share) {
        return text(share * 100);
    }
}
