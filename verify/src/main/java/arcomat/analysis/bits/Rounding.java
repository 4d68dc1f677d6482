package arcomat.analysis.bits;

import java.util.Arrays;

/**
 * Rounds to the nearest number of a format, and of two to the even one: with bits beyond the last
 * one, of which all but the first may be one bit that says whether there were any (Muller and
 * others, "Handbook of Floating-Point Arithmetic", 2nd edition, 2018, chapter 8).
 */
final class Rounding {
    /** Bits of an exponent on the way, with its sign. */
    static final int EXPONENT = 14;

    private final Circuit circuit;
    private final RealFormat format;

    Rounding(Circuit circuit, RealFormat format) {
        this.circuit = circuit;
        this.format = format;
    }

    /**
     * A significand without a sign, of which the first bit counts 1 where the exponent is the bias.
     */
    record Scaled(int[] exponent, int[] significand) {}

    /** The same number with a significand that begins with a one; 0 stays as it is. */
    static Scaled normalized(Scaled number, Circuit circuit) {
        int[] left = number.significand;
        int[] distance = circuit.constant(0, EXPONENT);
        for (int stage = stages(left.length - 1) - 1; stage >= 0; stage--) {
            int far = 1 << stage;
            int empty = -circuit.any(left, left.length - far, left.length);
            left = circuit.choose(empty, circuit.placed(left, far, left.length), left);
            distance[stage] = empty;
        }
        return new Scaled(circuit.difference(number.exponent, distance), left);
    }

    /** So many bits has a number. */
    private static int stages(int number) {
        return Integer.SIZE - Integer.numberOfLeadingZeros(number);
    }

    /**
     * To the right; the last bit also says whether anything has been lost.
     *
     * @param distance without a sign
     */
    static int[] shiftedRight(int[] bits, int[] distance, Circuit circuit) {
        int stages = stages(bits.length);
        int[] right = bits;
        for (int stage = 0; stage < stages; stage++) {
            int[] shifted = shiftedRight(right, 1 << stage, circuit);
            right = circuit.choose(distance[stage], shifted, right);
        }
        int all = circuit.any(distance, stages, distance.length);
        return circuit.choose(all, shiftedRight(bits, bits.length, circuit), right);
    }

    private static int[] shiftedRight(int[] bits, int far, Circuit circuit) {
        int[] shifted = circuit.constant(0, bits.length);
        for (int i = far; i < bits.length; i++) {
            shifted[i - far] = bits[i];
        }
        shifted[0] = circuit.any(bits, 0, Math.min(far + 1, bits.length));
        return shifted;
    }

    /**
     * The pattern of the nearest number.
     *
     * @param number has at least three bits more than a fraction
     */
    int[] rounded(int sign, Scaled number) {
        Scaled normalized = normalized(number, circuit);
        int[] exponent = normalized.exponent;
        int[] least = circuit.constant(1, EXPONENT);
        int[] below = circuit.difference(least, exponent);
        int isSmall = circuit.isLess(exponent, least);
        int[] distance = circuit.choose(isSmall, below, circuit.constant(0, EXPONENT));
        int[] significand = shiftedRight(normalized.significand, distance, circuit);
        return packed(sign, circuit.choose(isSmall, least, exponent), significand);
    }

    /** A carry out of the fraction belongs to the exponent: it is a number of one more bit then. */
    private int[] packed(int sign, int[] exponent, int[] significand) {
        int fraction = format.fractionWidth();
        int top = significand.length - 1;
        int[] number = new int[fraction + EXPONENT];
        System.arraycopy(significand, top - fraction, number, 0, fraction);
        for (int i = 0; i < EXPONENT; i++) {
            number[fraction + i] = circuit.and(significand[top], exponent[i]);
        }
        int half = significand[top - fraction - 1];
        int more = circuit.any(significand, 0, top - fraction - 1);
        int up = circuit.and(half, circuit.or(more, number[0]));
        int[] nearest = circuit.sum(number, circuit.constant(0, number.length), up);
        int[] field = Arrays.copyOfRange(nearest, fraction, nearest.length);
        int overflows = -circuit.isLess(field, circuit.constant(format.beyond(), EXPONENT));
        int[] finite = Arrays.copyOf(nearest, format.width());
        int[] infinite = circuit.constant(format.infinity(), format.width());
        int[] packed = circuit.choose(overflows, infinite, finite);
        packed[format.width() - 1] = sign;
        return packed;
    }
}
