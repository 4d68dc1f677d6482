package arcomat.analysis.bits;

import arcomat.analysis.bits.Rounding.Scaled;

import java.util.Arrays;
import java.util.OptionalLong;
import java.util.stream.LongStream;

/**
 * Arithmetic of floating point as circuits, exactly as Java has it (IEEE 754, rounded to the
 * nearest, with numbers below the normal ones): Brillout, Kroening, Wahl, "Mixed abstractions for
 * floating-point arithmetic", FMCAD 2009; the algorithms are those of Muller and others, "Handbook
 * of Floating-Point Arithmetic".
 */
final class FloatingPoint {
    /** Bits behind a fraction that are enough to round a sum. */
    private static final int SPARE = 3;

    private final Circuit circuit;
    private final RealFormat format;
    private final Rounding rounding;

    FloatingPoint(Circuit circuit, RealFormat format) {
        this.circuit = circuit;
        this.format = format;
        this.rounding = new Rounding(circuit, format);
    }

    private int sign(int[] number) {
        return number[format.width() - 1];
    }

    private int hasExponent(int[] number) {
        return circuit.any(number, format.fractionWidth(), format.width() - 1);
    }

    private int isBeyond(int[] number) {
        int[] field = Arrays.copyOfRange(number, format.fractionWidth(), format.width() - 1);
        return -circuit.any(circuit.complement(field), 0, field.length);
    }

    private int hasFraction(int[] number) {
        return circuit.any(number, 0, format.fractionWidth());
    }

    private int isInfinite(int[] number) {
        return circuit.and(isBeyond(number), -hasFraction(number));
    }

    private int isNoNumber(int[] number) {
        return circuit.and(isBeyond(number), hasFraction(number));
    }

    private int isZero(int[] number) {
        return -circuit.any(number, 0, format.width() - 1);
    }

    /** Whether it is a pattern that messages have. */
    int isPattern(int[] number) {
        return circuit.or(-isNoNumber(number), circuit.areEqual(number, noNumber()));
    }

    private int[] noNumber() {
        return circuit.constant(format.notANumber(), format.width());
    }

    private int[] signed(int sign, long size) {
        int[] number = circuit.constant(size, format.width());
        number[format.width() - 1] = sign;
        return number;
    }

    private int[] infinity(int sign) {
        return signed(sign, format.infinity());
    }

    private int[] zero(int sign) {
        return signed(sign, 0);
    }

    /** Its size, a pattern without a sign: larger numbers have larger ones. */
    private int[] size(int[] number) {
        return Arrays.copyOf(number, format.width() - 1);
    }

    /** Whether it is 0, or has few bits, and not many of them behind the point. */
    int isShort(int[] number, int width) {
        int[] exponent = scaled(number).exponent();
        int isSmall = circuit.isLess(exponent, exponent(format.bias() + width));
        int isLarge = circuit.isLess(exponent(format.bias() - width / 2), exponent);
        int isLong = circuit.any(number, 0, format.fractionWidth() - width);
        int few = circuit.and(-isLong, circuit.and(isSmall, isLarge));
        return circuit.or(circuit.areEqual(number, zero(circuit.of(false))), few);
    }

    int areEqual(int[] a, int[] b) {
        int alike = circuit.or(circuit.areEqual(a, b), circuit.and(isZero(a), isZero(b)));
        return circuit.and(areNumbers(a, b), alike);
    }

    private int areNumbers(int[] a, int[] b) {
        return circuit.and(-isNoNumber(a), -isNoNumber(b));
    }

    int isLess(int[] a, int[] b) {
        int[] small = circuit.choose(sign(a), size(b), size(a));
        int[] large = circuit.choose(sign(a), size(a), size(b));
        int below = circuit.isBelow(small, large);
        int apart = circuit.and(sign(a), -circuit.and(isZero(a), isZero(b)));
        int less = circuit.choose(circuit.xor(sign(a), sign(b)), apart, below);
        return circuit.and(areNumbers(a, b), less);
    }

    int isAtMost(int[] a, int[] b) {
        return circuit.or(isLess(a, b), areEqual(a, b));
    }

    int[] negated(int[] number) {
        int[] negated = number.clone();
        negated[format.width() - 1] = circuit.xor(sign(number), -isNoNumber(number));
        return negated;
    }

    /** What is finite, without its sign. */
    Scaled scaled(int[] number) {
        int fraction = format.fractionWidth();
        int normal = hasExponent(number);
        int[] significand = Arrays.copyOf(number, fraction + 1);
        significand[fraction] = normal;
        int[] field = Arrays.copyOfRange(number, fraction, format.width() - 1);
        int[] exponent = circuit.placed(field, 0, Rounding.EXPONENT);
        exponent[0] = circuit.or(exponent[0], -normal);
        return new Scaled(exponent, significand);
    }

    private int[] exponent(long number) {
        return circuit.constant(number, Rounding.EXPONENT);
    }

    int[] difference(int[] a, int[] b) {
        return sum(a, negated(b));
    }

    /** The same gates, whichever comes first. */
    int[] sum(int[] one, int[] other) {
        boolean inOrder = Circuit.isFirst(one, other);
        int[] a = inOrder ? one : other;
        int[] b = inOrder ? other : one;
        int swapped = circuit.isBelow(size(a), size(b));
        int[] large = circuit.choose(swapped, b, a);
        int[] small = circuit.choose(swapped, a, b);
        int opposite = circuit.xor(sign(a), sign(b));
        int none = circuit.and(circuit.and(isInfinite(a), isInfinite(b)), opposite);
        return special(
                circuit.or(-areNumbers(a, b), none),
                circuit.or(isInfinite(a), isInfinite(b)),
                sign(large),
                finiteSum(large, small, opposite));
    }

    /** The smaller one is put below the larger one, and what sticks out leaves a trace. */
    private int[] finiteSum(int[] large, int[] small, int opposite) {
        Scaled upper = scaled(large);
        Scaled lower = scaled(small);
        int[] distance = circuit.difference(upper.exponent(), lower.exponent());
        int[] above = withSpace(upper.significand());
        int[] below = Rounding.shiftedRight(withSpace(lower.significand()), distance, circuit);
        int[] signed = Arrays.stream(below).map(bit -> circuit.xor(bit, opposite)).toArray();
        int[] total = circuit.sum(above, signed, opposite);
        int zeros = circuit.and(sign(large), sign(small));
        int sign = circuit.choose(circuit.any(total, 0, total.length), sign(large), zeros);
        int[] exponent = circuit.sum(upper.exponent(), exponent(1));
        return rounding.rounded(sign, new Scaled(exponent, total));
    }

    /** Spare bits at the end, and one for the carry. */
    private int[] withSpace(int[] significand) {
        return circuit.placed(significand, SPARE, SPARE + significand.length + 1);
    }

    private int[] special(int isNoNumber, int isInfinite, int sign, int[] finite) {
        return circuit.choose(
                isNoNumber, noNumber(), circuit.choose(isInfinite, infinity(sign), finite));
    }

    int[] product(int[] a, int[] b) {
        int sign = circuit.xor(sign(a), sign(b));
        int infinite = circuit.or(isInfinite(a), isInfinite(b));
        int none = circuit.and(infinite, circuit.or(isZero(a), isZero(b)));
        Scaled one = scaled(a);
        Scaled other = scaled(b);
        int[] exponent = circuit.sum(one.exponent(), other.exponent());
        exponent = circuit.sum(exponent, exponent(1 - format.bias()));
        int[] significand = circuit.product(twice(one.significand()), twice(other.significand()));
        return special(
                circuit.or(-areNumbers(a, b), none),
                infinite,
                sign,
                rounding.rounded(sign, new Scaled(exponent, significand)));
    }

    /** In twice as many bits. */
    private int[] twice(int[] significand) {
        return circuit.placed(significand, 0, 2 * significand.length);
    }

    /** To divide by a power of two is to multiply by another one: both are rounded alike. */
    int[] quotient(int[] a, int[] b) {
        OptionalLong inverse = circuit.known(b).stream().flatMap(this::inverse).findFirst();
        return inverse.isPresent()
                ? product(a, circuit.constant(inverse.getAsLong(), format.width()))
                : divided(a, b);
    }

    /** Of a power of two, if that is a normal number too. */
    private LongStream inverse(long number) {
        long exponent = number >> format.fractionWidth() & format.beyond();
        long opposite = 2L * format.bias() - exponent;
        boolean isPower = (number & (1L << format.fractionWidth()) - 1) == 0;
        long sign = number & 1L << format.width() - 1;
        return isPower && exponent > 0 && opposite > 0
                ? LongStream.of(sign | opposite << format.fractionWidth())
                : LongStream.empty();
    }

    private int[] divided(int[] a, int[] b) {
        int sign = circuit.xor(sign(a), sign(b));
        int zeros = circuit.and(isZero(a), isZero(b));
        int infinities = circuit.and(isInfinite(a), isInfinite(b));
        int none = circuit.or(-areNumbers(a, b), circuit.or(zeros, infinities));
        int[] finite = circuit.choose(isInfinite(b), zero(sign), finiteQuotient(a, b, sign));
        return special(none, circuit.or(isInfinite(a), isZero(b)), sign, finite);
    }

    /** As on paper, bit by bit; whether a rest is left stands in the last bit. */
    private int[] finiteQuotient(int[] a, int[] b, int sign) {
        Scaled dividend = Rounding.normalized(scaled(a), circuit);
        Scaled divisor = Rounding.normalized(scaled(b), circuit);
        int[] by = longer(divisor.significand());
        int[] rest = longer(dividend.significand());
        int[] quotient = circuit.constant(0, format.fractionWidth() + 1 + SPARE);
        for (int i = quotient.length - 1; i > 0; i--) {
            quotient[i] = -circuit.isBelow(rest, by);
            int[] left = circuit.choose(quotient[i], circuit.difference(rest, by), rest);
            rest = circuit.placed(left, 1, left.length);
        }
        quotient[0] = circuit.any(rest, 0, rest.length);
        int[] exponent = circuit.difference(dividend.exponent(), divisor.exponent());
        exponent = circuit.sum(exponent, exponent(format.bias()));
        return rounding.rounded(sign, new Scaled(exponent, quotient));
    }

    private int[] longer(int[] significand) {
        return circuit.placed(significand, 0, significand.length + 1);
    }

    /** The number that is nearest to one of another format. */
    int[] converted(int[] number, RealFormat from) {
        FloatingPoint own = new FloatingPoint(circuit, from);
        Scaled scaled = own.scaled(number);
        int[] exponent = circuit.sum(scaled.exponent(), exponent(format.bias() - from.bias()));
        int[] finite = rounding.rounded(own.sign(number), atLeast(exponent, scaled.significand()));
        return special(own.isNoNumber(number), own.isInfinite(number), own.sign(number), finite);
    }

    /** With zeros behind, so that it can be rounded. */
    private Scaled atLeast(int[] exponent, int[] significand) {
        int width = Math.max(significand.length, format.fractionWidth() + SPARE);
        int[] wide = circuit.placed(significand, width - significand.length, width);
        return new Scaled(exponent, wide);
    }

    /** The number that is nearest to a whole one. */
    int[] ofWhole(int[] whole) {
        int[] size = circuit.absolute(whole);
        int[] exponent = exponent(format.bias() + whole.length - 1L);
        return rounding.rounded(whole[whole.length - 1], atLeast(exponent, size));
    }

    /**
     * The whole number that is next to it on the way to 0; the least or largest one beyond these, 0
     * for what is no number.
     */
    int[] toWhole(int[] number, int width) {
        Scaled scaled = scaled(number);
        int[] power = circuit.difference(scaled.exponent(), exponent(format.bias()));
        int[] shifted = circuit.placed(scaled.significand(), 0, format.fractionWidth() + width);
        for (int stage = 0; 1 << stage < width; stage++) {
            int[] farther = circuit.placed(shifted, 1 << stage, shifted.length);
            shifted = circuit.choose(power[stage], farther, shifted);
        }
        int[] size = Arrays.copyOfRange(shifted, format.fractionWidth(), shifted.length);
        int[] signed = circuit.choose(sign(number), circuit.negated(size), size);
        int[] least = circuit.constant(Long.MIN_VALUE >> Long.SIZE - width, width);
        int[] farthest = circuit.choose(sign(number), least, circuit.complement(least));
        int isFar = -circuit.isLess(power, exponent(width - 1L));
        int none = circuit.or(power[power.length - 1], isNoNumber(number));
        int[] zero = circuit.constant(0, width);
        return circuit.choose(none, zero, circuit.choose(isFar, farthest, signed));
    }
}
