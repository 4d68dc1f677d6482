package arcomat.analysis.bits;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.symbolic.CheckedSolver;
import arcomat.analysis.symbolic.Clauses;
import arcomat.model.Type;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.Arrays;
import java.util.Random;
import java.util.function.BiFunction;
import java.util.function.LongUnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Java is the expectation: circuits give what it gives, to the last bit. */
class FloatingPointTest {
    private static final int PAIRS = 4_000;

    /** A circuit that is made once has as many gates as it gets; to ask it takes longer. */
    private static final int PAIRS_OF_ONE_CIRCUIT = 150;

    private static final RealFormat DOUBLE = RealFormat.of(new Type.RealType(false));
    private static final RealFormat SINGLE = RealFormat.of(new Type.RealType(true));

    private static final double[] NOTABLE = {
        0.0,
        Double.MIN_VALUE,
        2 * Double.MIN_VALUE,
        Math.nextDown(Double.MIN_NORMAL),
        Double.MIN_NORMAL,
        Math.nextUp(Double.MIN_NORMAL),
        Double.MAX_VALUE,
        Math.nextDown(Double.MAX_VALUE),
        Double.MAX_VALUE / 2,
        Double.POSITIVE_INFINITY,
        Double.NaN,
        Math.nextDown(1.0),
        1,
        Math.nextUp(1.0),
        2,
        0.5,
        1.5,
        3,
        0.1,
        10,
        0x1p52,
        0x1p53,
        0x1p53 - 1,
        0x1p53 + 2,
        0x1p31,
        0x1p31 - 1,
        0x1p31 - 0.5,
        0x1p63,
        0x1p63 - 1024,
        0x1p-1022,
        0x1p1023,
        0x1p24 + 1,
        Float.MIN_VALUE,
        Float.MIN_VALUE / 2.0,
        Math.nextUp(Float.MIN_VALUE / 2.0),
        Float.MIN_NORMAL,
        Math.nextDown((double) Float.MIN_NORMAL),
        Float.MAX_VALUE,
        0x1.ffffffp127,
        Math.nextDown(0x1.ffffffp127),
    };

    private static final long[] WHOLE = {
        0,
        1,
        -1,
        2,
        3,
        7,
        -8,
        255,
        1L << 24,
        (1L << 24) + 1,
        (1L << 24) + 3,
        Integer.MAX_VALUE,
        Integer.MIN_VALUE,
        1L << 53,
        (1L << 53) + 1,
        (1L << 53) + 3,
        Long.MAX_VALUE,
        Long.MAX_VALUE - 511,
        Long.MAX_VALUE - 512,
        Long.MIN_VALUE,
        Long.MIN_VALUE + 1,
    };

    /** What Java gives for two numbers, and what a circuit has instead. */
    private enum Operation {
        SUM((a, b) -> a + b, (a, b) -> a + b, FloatingPoint::sum),
        DIFFERENCE((a, b) -> a - b, (a, b) -> a - b, FloatingPoint::difference),
        PRODUCT((a, b) -> a * b, (a, b) -> a * b, FloatingPoint::product),
        QUOTIENT((a, b) -> a / b, (a, b) -> a / b, FloatingPoint::quotient),
        NEGATION((a, b) -> -a, (a, b) -> -a, (reals, a, b) -> reals.negated(a)),
        LESS(
                (a, b) -> truth(a < b),
                (a, b) -> (float) truth(a < b),
                (reals, a, b) -> one(reals.isLess(a, b))),
        AT_MOST(
                (a, b) -> truth(a <= b),
                (a, b) -> (float) truth(a <= b),
                (reals, a, b) -> one(reals.isAtMost(a, b))),
        EQUAL(
                (a, b) -> truth(a.doubleValue() == b),
                (a, b) -> (float) truth(a.floatValue() == b),
                (reals, a, b) -> one(reals.areEqual(a, b)));

        private final BiFunction<Double, Double, Double> onDoubles;
        private final BiFunction<Float, Float, Float> onSingles;
        private final Gates gates;

        Operation(
                BiFunction<Double, Double, Double> onDoubles,
                BiFunction<Float, Float, Float> onSingles,
                Gates gates) {
            this.onDoubles = onDoubles;
            this.onSingles = onSingles;
            this.gates = gates;
        }

        private boolean isCondition() {
            return ordinal() >= LESS.ordinal();
        }

        private long expected(RealFormat format, long a, long b) {
            double one = format.real(a);
            double other = format.real(b);
            double result =
                    format.single()
                            ? onSingles.apply((float) one, (float) other)
                            : onDoubles.apply(one, other);
            return isCondition() ? (long) result : format.code(result);
        }
    }

    private interface Gates {
        int[] of(FloatingPoint reals, int[] a, int[] b);
    }

    private static double truth(boolean is) {
        return is ? 1 : 0;
    }

    private static int[] one(int literal) {
        return new int[] {literal};
    }

    @Tag("some-slow")
    @ParameterizedTest
    @EnumSource
    void doublesAreThoseOfJava(Operation operation) {
        compare(operation, DOUBLE);
    }

    @Tag("some-slow")
    @ParameterizedTest
    @EnumSource
    void singlesAreThoseOfJava(Operation operation) {
        compare(operation, SINGLE);
    }

    private static void compare(Operation operation, RealFormat format) {
        Random random = new Random(operation.ordinal());
        Circuit circuit = new Circuit(new Clauses());
        FloatingPoint reals = new FloatingPoint(circuit, format);
        for (int i = 0; i < PAIRS; i++) {
            long[] pair = pair(i, format, random);
            int[] result =
                    operation.gates.of(
                            reals,
                            circuit.constant(pair[0], format.width()),
                            circuit.constant(pair[1], format.width()));
            assertThat(known(circuit, result))
                    .as(about(operation, pair, format))
                    .isEqualTo(bits(operation.expected(format, pair[0], pair[1]), result.length));
        }
    }

    /** What is known beforehand takes other ways than what is asked of a solver. */
    @Tag("some-slow")
    @ParameterizedTest
    @EnumSource
    void oneCircuitIsRightForAll(Operation operation) {
        Random random = new Random(operation.ordinal());
        CheckedSolver solver = new CheckedSolver(() -> {});
        Circuit circuit = new Circuit(solver.clauses());
        int[] a = circuit.input(DOUBLE.width());
        int[] b = circuit.input(DOUBLE.width());
        int[] result = operation.gates.of(new FloatingPoint(circuit, DOUBLE), a, b);
        for (int i = 0; i < PAIRS_OF_ONE_CIRCUIT; i++) {
            long[] pair = pair(random.nextInt(PAIRS), DOUBLE, random);
            int[] assumed = IntStream.concat(assumed(a, pair[0]), assumed(b, pair[1])).toArray();
            assertThat(solver.solveWith(assumed)).isTrue();
            assertThat(found(solver, result))
                    .as(about(operation, pair, DOUBLE))
                    .isEqualTo(bits(operation.expected(DOUBLE, pair[0], pair[1]), result.length));
        }
    }

    private static IntStream assumed(int[] bits, long number) {
        return IntStream.range(0, bits.length)
                .map(i -> (number >> i & 1) == 1 ? bits[i] : -bits[i]);
    }

    private static long found(CheckedSolver solver, int[] bits) {
        return IntStream.range(0, bits.length)
                .mapToLong(i -> solver.isTrue(bits[i]) ? 1L << i : 0)
                .sum();
    }

    private static long known(Circuit circuit, int[] result) {
        return circuit.known(result).orElseThrow();
    }

    private static long bits(long number, int width) {
        return width == Long.SIZE ? number : number & (1L << width) - 1;
    }

    private static String about(Operation operation, long[] pair, RealFormat format) {
        return "%s of %s and %s".formatted(operation, format.real(pair[0]), format.real(pair[1]));
    }

    /** All notable numbers first, then patterns in which something happens. */
    private static long[] pair(int number, RealFormat format, Random random) {
        int signed = 2 * NOTABLE.length;
        if (number < signed * signed) {
            return new long[] {notable(number / signed, format), notable(number % signed, format)};
        }
        long a = pattern(format, random);
        long b = random.nextInt(3) == 0 ? beside(a, format, random) : pattern(format, random);
        return random.nextBoolean() ? new long[] {a, b} : new long[] {b, a};
    }

    private static long notable(int number, RealFormat format) {
        double size = NOTABLE[number / 2];
        return format.code(number % 2 == 0 ? size : -size);
    }

    private static long pattern(RealFormat format, Random random) {
        long any = random.nextLong();
        long few = any & (random.nextInt(8) | random.nextLong() & -1L << 50 - random.nextInt(20));
        return switch (random.nextInt(4)) {
            case 0 -> notable(random.nextInt(2 * NOTABLE.length), format);
            case 1 -> canonical(any, format);
            default -> canonical(few, format);
        };
    }

    /** A number of about the same size: then sums cancel out, and quotients are near to 1. */
    private static long beside(long pattern, RealFormat format, Random random) {
        long exponents = random.nextInt(2 * format.fractionWidth() + 8) - format.fractionWidth();
        long change = random.nextBoolean() ? random.nextInt(5) - 2L : random.nextLong();
        long fraction = change & (1L << format.fractionWidth()) - 1;
        long near =
                random.nextBoolean()
                        ? pattern + change % 3
                        : pattern + (exponents << format.fractionWidth()) ^ fraction;
        return canonical(random.nextBoolean() ? near : near ^ 1L << format.width() - 1, format);
    }

    private static long canonical(long pattern, RealFormat format) {
        return format.code(format.real(pattern));
    }

    @Tag("slow")
    @Test
    void wholeNumbersBecomeTheNearest() {
        compareWhole(DOUBLE, Long.SIZE, number -> DOUBLE.code((double) number));
        compareWhole(DOUBLE, Integer.SIZE, number -> DOUBLE.code((double) (int) number));
        compareWhole(SINGLE, Long.SIZE, number -> SINGLE.code((float) number));
        compareWhole(SINGLE, Integer.SIZE, number -> SINGLE.code((float) (int) number));
    }

    private static void compareWhole(RealFormat format, int width, LongUnaryOperator expected) {
        Circuit circuit = new Circuit(new Clauses());
        Random random = new Random(width);
        for (int i = 0; i < PAIRS; i++) {
            long number =
                    i < WHOLE.length ? WHOLE[i] : random.nextLong() >> random.nextInt(Long.SIZE);
            int[] result =
                    new FloatingPoint(circuit, format).ofWhole(circuit.constant(number, width));
            assertThat(known(circuit, result))
                    .as("%d in %d bits", number, width)
                    .isEqualTo(bits(expected.applyAsLong(number), format.width()));
        }
    }

    @Tag("slow")
    @Test
    void whatIsNotWholeIsCutOff() {
        compareCut(DOUBLE, Long.SIZE, code -> (long) DOUBLE.real(code));
        compareCut(DOUBLE, Integer.SIZE, code -> (int) DOUBLE.real(code));
        compareCut(SINGLE, Long.SIZE, code -> (long) SINGLE.real(code));
        compareCut(SINGLE, Integer.SIZE, code -> (int) SINGLE.real(code));
    }

    private static void compareCut(RealFormat format, int width, LongUnaryOperator expected) {
        Circuit circuit = new Circuit(new Clauses());
        patterns(format)
                .forEach(
                        code -> {
                            int[] number = circuit.constant(code, format.width());
                            int[] whole = new FloatingPoint(circuit, format).toWhole(number, width);
                            assertThat(known(circuit, whole))
                                    .as("%s in %d bits", format.real(code), width)
                                    .isEqualTo(bits(expected.applyAsLong(code), width));
                        });
    }

    @Tag("slow")
    @Test
    void otherFormatsHaveTheNearest() {
        compareConverted(DOUBLE, SINGLE);
        compareConverted(SINGLE, DOUBLE);
    }

    private static void compareConverted(RealFormat from, RealFormat to) {
        Circuit circuit = new Circuit(new Clauses());
        patterns(from)
                .forEach(
                        code -> {
                            int[] number = circuit.constant(code, from.width());
                            int[] near = new FloatingPoint(circuit, to).converted(number, from);
                            assertThat(known(circuit, near))
                                    .as("%s", from.real(code))
                                    .isEqualTo(bits(to.code(from.real(code)), to.width()));
                        });
    }

    /** Numbers about as large as whole ones, and around the ends of smaller formats, among them. */
    private static Stream<Long> patterns(RealFormat format) {
        Random random = new Random(format.width());
        Stream<Long> sizes =
                Stream.generate(
                                () ->
                                        Math.scalb(
                                                random.nextDouble() * 2 - 1,
                                                random.nextInt(320) - 160))
                        .limit(PAIRS / 2)
                        .map(format::code);
        Stream<Long> any = IntStream.range(0, PAIRS / 2).mapToObj(i -> pair(i, format, random)[1]);
        return Stream.concat(sizes, any);
    }

    /** A message that is no number has one pattern, and all others are numbers. */
    @Test
    void onePatternIsNoNumber() {
        Circuit circuit = new Circuit(new Clauses());
        FloatingPoint reals = new FloatingPoint(circuit, DOUBLE);
        Random random = new Random(1);
        for (int i = 0; i < PAIRS; i++) {
            long pattern = random.nextLong() | (i % 2 == 0 ? DOUBLE.infinity() : 0);
            boolean is = pattern == DOUBLE.notANumber() || !Double.isNaN(DOUBLE.real(pattern));
            int[] truth = one(reals.isPattern(circuit.constant(pattern, Long.SIZE)));
            assertThat(known(circuit, truth)).isEqualTo(is ? 1 : 0);
        }
        long only = DOUBLE.notANumber();
        assertThat(Arrays.stream(new long[] {only, only | 1, only | 1L << 63}))
                .filteredOn(
                        each ->
                                known(
                                                circuit,
                                                one(
                                                        reals.isPattern(
                                                                circuit.constant(each, Long.SIZE))))
                                        == 1)
                .containsExactly(only);
    }
}
