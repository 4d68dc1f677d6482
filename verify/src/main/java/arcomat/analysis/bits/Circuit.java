package arcomat.analysis.bits;

import arcomat.analysis.symbolic.Clauses;
import arcomat.semantics.value.GivenUp;

import com.carrotsearch.hppc.LongIntHashMap;

import java.util.Arrays;
import java.util.OptionalLong;
import java.util.stream.IntStream;

/**
 * Gates in clauses (Tseitin 1968). Numbers are arrays of literals, the least bit first, and the
 * last one is the sign (two's complement). What is known beforehand needs no gate.
 */
final class Circuit {
    /** As many as some divisions of 64 bits have; more would take too much memory. */
    private static final int MOST_GATES = 200_000;

    private final Clauses clauses;

    /** By their inputs, the smaller one first. */
    private final LongIntHashMap both = new LongIntHashMap();

    private final LongIntHashMap different = new LongIntHashMap();

    Circuit(Clauses clauses) {
        this.clauses = clauses;
    }

    /** One more is needed. */
    private void insist() {
        if (gates() >= MOST_GATES) {
            throw new GivenUp("too many gates");
        }
    }

    /** How many there are. */
    int gates() {
        return both.size() + different.size();
    }

    int of(boolean truth) {
        return truth ? clauses.truth() : -clauses.truth();
    }

    private boolean isTrue(int literal) {
        return literal == clauses.truth();
    }

    private boolean isFalse(int literal) {
        return literal == -clauses.truth();
    }

    private boolean isKnown(int literal) {
        return isTrue(literal) || isFalse(literal);
    }

    /** The number that some bits are beforehand; nothing where it depends on something. */
    OptionalLong known(int[] number) {
        if (!Arrays.stream(number).allMatch(this::isKnown)) {
            return OptionalLong.empty();
        }
        long known = 0;
        for (int i = 0; i < number.length; i++) {
            known |= isTrue(number[i]) ? 1L << i : 0;
        }
        return OptionalLong.of(known);
    }

    int and(int a, int b) {
        if (isFalse(a) || isFalse(b) || a == -b) {
            return of(false);
        }
        if (isTrue(a) || a == b) {
            return b;
        }
        if (isTrue(b)) {
            return a;
        }
        long inputs = inputs(a, b);
        if (!both.containsKey(inputs)) {
            insist();
            both.put(inputs, clauses.and(a, b));
        }
        return both.get(inputs);
    }

    int and(IntStream all) {
        return all.reduce(of(true), this::and);
    }

    int or(int a, int b) {
        return -and(-a, -b);
    }

    int xor(int a, int b) {
        if (isFalse(a) || isTrue(a)) {
            return isTrue(a) ? -b : b;
        }
        if (isFalse(b) || isTrue(b)) {
            return isTrue(b) ? -a : a;
        }
        if (a == b || a == -b) {
            return of(a != b);
        }
        long inputs = inputs(Math.abs(a), Math.abs(b));
        if (!different.containsKey(inputs)) {
            insist();
            different.put(inputs, differs(Math.abs(a), Math.abs(b)));
        }
        int gate = different.get(inputs);
        return a > 0 == b > 0 ? gate : -gate;
    }

    private static long inputs(int a, int b) {
        return (long) Math.min(a, b) << 32 | Math.max(a, b) & 0xFFFF_FFFFL;
    }

    private int differs(int a, int b) {
        int gate = clauses.variable();
        clauses.add(-gate, a, b);
        clauses.add(-gate, -a, -b);
        clauses.add(gate, -a, b);
        clauses.add(gate, a, -b);
        return gate;
    }

    /** Whether one of some bits is set. */
    int any(int[] bits, int from, int to) {
        int any = of(false);
        for (int i = from; i < to; i++) {
            any = or(any, bits[i]);
        }
        return any;
    }

    int choose(int condition, int then, int otherwise) {
        return then == otherwise ? then : or(and(condition, then), and(-condition, otherwise));
    }

    int[] choose(int condition, int[] then, int[] otherwise) {
        int[] chosen = new int[then.length];
        Arrays.setAll(chosen, i -> choose(condition, then[i], otherwise[i]));
        return chosen;
    }

    int[] constant(long number, int width) {
        int[] bits = new int[width];
        Arrays.setAll(bits, i -> of((number >> Math.min(i, Long.SIZE - 1) & 1) != 0));
        return bits;
    }

    /** Of whatever value. */
    int[] input(int width) {
        int[] bits = new int[width];
        Arrays.setAll(bits, i -> clauses.variable());
        return bits;
    }

    /** The same number in more bits, or what is left of it in fewer. */
    static int[] resized(int[] number, int width) {
        int[] bits = new int[width];
        Arrays.setAll(bits, i -> number[Math.min(i, number.length - 1)]);
        return bits;
    }

    /**
     * Some bits among zeros; those that do not fit are gone.
     *
     * @param at position of the first one
     */
    int[] placed(int[] bits, int at, int width) {
        int[] placed = constant(0, width);
        System.arraycopy(bits, 0, placed, at, Math.min(bits.length, width - at));
        return placed;
    }

    int[] complement(int[] number) {
        return Arrays.stream(number).map(bit -> -bit).toArray();
    }

    int[] sum(int[] a, int[] b) {
        return sum(a, b, of(false));
    }

    /** How many bits a number has that are not all copies of its sign. */
    private static int needed(int[] number) {
        int needed = number.length;
        while (needed > 1 && number[needed - 1] == number[needed - 2]) {
            needed--;
        }
        return needed;
    }

    int[] difference(int[] a, int[] b) {
        return sum(a, complement(b), of(true));
    }

    int[] negated(int[] number) {
        return difference(constant(0, number.length), number);
    }

    /**
     * @param carry a literal: one more where it is true
     */
    int[] sum(int[] a, int[] b, int carry) {
        int enough = Math.max(needed(a), needed(b)) + 1;
        return enough < a.length
                ? resized(added(resized(a, enough), resized(b, enough), carry), a.length)
                : added(a, b, carry);
    }

    private int[] added(int[] a, int[] b, int carry) {
        int[] sum = new int[a.length];
        int over = carry;
        for (int i = 0; i < a.length; i++) {
            int half = xor(a[i], b[i]);
            sum[i] = xor(half, over);
            over = or(and(a[i], b[i]), and(half, over));
        }
        return sum;
    }

    /** What fits of it; the same bits for the same factors, whichever comes first. */
    int[] product(int[] one, int[] other) {
        int enough = needed(one) + needed(other);
        if (enough < one.length) {
            return resized(product(resized(one, enough), resized(other, enough)), one.length);
        }
        int width = one.length;
        boolean inOrder = isFirst(one, other);
        int[] a = inOrder ? one : other;
        int[] b = inOrder ? other : one;
        int[] product = constant(0, width);
        for (int shift = 0; shift < width; shift++) {
            int[] row = constant(0, width);
            for (int i = shift; i < width; i++) {
                row[i] = and(a[i - shift], b[shift]);
            }
            product = sum(product, row);
        }
        return product;
    }

    /** Some order of operands, of which it does not matter which one comes first. */
    static boolean isFirst(int[] one, int[] other) {
        int i = 0;
        while (i < one.length - 1 && one[i] == other[i]) {
            i++;
        }
        return one[i] <= other[i];
    }

    /** A quotient and its rest. */
    record Division(int[] quotient, int[] rest) {}

    /** Rounded towards zero, as Java does; whatever it is where the divisor is zero. */
    Division divided(int[] dividend, int[] divisor) {
        int width = dividend.length;
        int negative = dividend[width - 1];
        int opposite = xor(negative, divisor[width - 1]);
        Division plain = withoutSign(absolute(dividend), absolute(divisor));
        return new Division(
                choose(opposite, negated(plain.quotient), plain.quotient),
                choose(negative, negated(plain.rest), plain.rest));
    }

    /** Of the least number it is its own pattern, which is right where there are no signs. */
    int[] absolute(int[] number) {
        return choose(number[number.length - 1], negated(number), number);
    }

    /** As on paper, bit by bit. The rest has one bit more on the way. */
    private Division withoutSign(int[] dividend, int[] divisor) {
        int width = dividend.length;
        int[] wide = placed(divisor, 0, width + 1);
        int[] quotient = new int[width];
        int[] rest = constant(0, width + 1);
        for (int i = width - 1; i >= 0; i--) {
            int[] next = placed(rest, 1, width + 1);
            next[0] = dividend[i];
            quotient[i] = -isBelow(next, wide);
            rest = choose(quotient[i], difference(next, wide), next);
        }
        return new Division(quotient, Arrays.copyOf(rest, width));
    }

    /** Of numbers without a sign. */
    int isBelow(int[] a, int[] b) {
        int below = of(false);
        for (int i = 0; i < a.length; i++) {
            below = choose(xor(a[i], b[i]), b[i], below);
        }
        return below;
    }

    int isLess(int[] a, int[] b) {
        int[] one = a.clone();
        int[] other = b.clone();
        one[a.length - 1] = -a[a.length - 1];
        other[b.length - 1] = -b[b.length - 1];
        return isBelow(one, other);
    }

    int areEqual(int[] a, int[] b) {
        int equal = of(true);
        for (int i = 0; i < a.length; i++) {
            equal = and(equal, -xor(a[i], b[i]));
        }
        return equal;
    }
}
