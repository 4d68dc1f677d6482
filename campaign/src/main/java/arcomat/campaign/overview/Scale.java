package arcomat.campaign.overview;

import java.math.BigDecimal;
import java.math.MathContext;

/**
 * Equal steps that people can read: 1, 2 or 5 times a power of ten.
 *
 * @param low where the first begins
 * @param width of each; 0 where all numbers are one
 * @param steps how many there are, at least 1
 * @param whole whether all numbers are whole
 */
public record Scale(double low, double width, int steps, boolean whole) {
    private static final int DIGITS = 4;

    /**
     * Steps around numbers.
     *
     * @param most how many steps are wanted at most; one or two more at the ends
     * @param whole whether all numbers are whole: then a step is not smaller than 1
     */
    static Scale around(double least, double greatest, int most, boolean whole) {
        if (least == greatest) {
            return new Scale(least, 0, 1, whole);
        }
        double width = nice((greatest - least) / most);
        if (whole) {
            width = Math.max(1, width);
        }
        double low = Math.floor(least / width) * width;
        int steps = (int) Math.floor((greatest - low) / width) + 1;
        return new Scale(low, width, steps, whole);
    }

    /** The next larger one of 1, 2, 5, 10, ... and their tenths. */
    private static double nice(double width) {
        double power = Math.pow(10, Math.floor(Math.log10(width)));
        double digit = width / power;
        if (digit <= 1) {
            return power;
        }
        if (digit <= 2) {
            return 2 * power;
        }
        return digit <= 5 ? 5 * power : 10 * power;
    }

    int step(double number) {
        return width == 0
                ? 0
                : (int) Math.max(0, Math.min(steps - 1, Math.floor((number - low) / width)));
    }

    /** Whether two digits say it all. */
    static boolean isShort(double width) {
        double rounded = new BigDecimal(width).round(new MathContext(2)).doubleValue();
        return Math.abs(rounded - width) <= 1e-9 * width;
    }

    /** With as many digits as can be read. */
    static String number(double value) {
        BigDecimal rounded = new BigDecimal(value).round(new MathContext(DIGITS));
        return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    }
}
