package arcomat.world.arithmetic;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** The functions of the world are those of StrictMath, bit for bit. */
class StrictFunctionsTest {
    private static final int DRAWN = 300_000;

    /** Multiples of an eighth turn, and numbers next to them, are where methods change. */
    private static DoubleStream turns() {
        return IntStream.range(-400, 400)
                .mapToDouble(eighths -> eighths * Math.PI / 4)
                .flatMap(StrictFunctionsTest::around);
    }

    private static DoubleStream around(double x) {
        double next = Math.nextUp(x);
        return DoubleStream.of(
                Math.nextDown(x), x, next, Math.nextUp(next), x * (1 + 0x1p-30), x * (1 + 0x1p-18));
    }

    private static DoubleStream drawn(double range) {
        Random random = new Random(1);
        return DoubleStream.generate(() -> (random.nextDouble() - 0.5) * 2 * range).limit(DRAWN);
    }

    private static DoubleStream small() {
        return IntStream.range(1, 60)
                .mapToDouble(i -> StrictMath.pow(2, -i))
                .flatMap(StrictFunctionsTest::around);
    }

    private static void assertSame(
            DoubleStream all, DoubleUnaryOperator own, DoubleUnaryOperator strict) {
        all.forEach(
                x ->
                        assertThat(Double.doubleToLongBits(own.applyAsDouble(x)))
                                .as("of %s", x)
                                .isEqualTo(Double.doubleToLongBits(strict.applyAsDouble(x))));
    }

    @Test
    void sine() {
        assertSame(turns(), Circle::sin, StrictMath::sin);
        assertSame(drawn(20), Circle::sin, StrictMath::sin);
        assertSame(drawn(1_000_000), Circle::sin, StrictMath::sin);
        assertSame(small(), Circle::sin, StrictMath::sin);
    }

    @Test
    void cosine() {
        assertSame(turns(), Circle::cos, StrictMath::cos);
        assertSame(drawn(20), Circle::cos, StrictMath::cos);
        assertSame(drawn(1_000_000), Circle::cos, StrictMath::cos);
        assertSame(small(), Circle::cos, StrictMath::cos);
    }

    @Test
    void tangents() {
        assertSame(turns(), Tangent::tan, StrictMath::tan);
        assertSame(drawn(4), Tangent::tan, StrictMath::tan);
        assertSame(small(), Tangent::tan, StrictMath::tan);
    }

    @Test
    void arcs() {
        Random random = new Random(2);
        assertSame(
                drawn(5000), y -> Arc.atan2(y, y * 3 - 70), y -> StrictMath.atan2(y, y * 3 - 70));
        for (int i = 0; i < DRAWN; i++) {
            double x = (random.nextDouble() - 0.5) * 6000;
            assertSame(
                    DoubleStream.of(0, -0.0, x, (random.nextDouble() - 0.5) * 6000),
                    y -> Arc.atan2(y, x),
                    y -> StrictMath.atan2(y, x));
        }
        assertThat(Arc.atan2(-3, 0)).isEqualTo(StrictMath.atan2(-3, 0));
        assertSame(small(), y -> Arc.atan2(y, 1), y -> StrictMath.atan2(y, 1));
        assertSame(small(), y -> Arc.atan2(1, y), y -> StrictMath.atan2(1, y));
    }

    @Test
    void decays() {
        DoubleUnaryOperator strict = x -> StrictMath.exp(-Math.abs(x));
        DoubleUnaryOperator own = x -> Decay.exp(-Math.abs(x));
        assertSame(drawn(3), own, strict);
        assertSame(drawn(800), own, strict);
        assertSame(small(), own, strict);
        assertSame(
                DoubleStream.of(0, Math.log(2) / 2, 1.5 * Math.log(2))
                        .flatMap(StrictFunctionsTest::around),
                own,
                strict);
    }

    @Test
    void nearestAngles() {
        DoubleUnaryOperator java = x -> Math.IEEEremainder(x, 2 * Math.PI);
        assertSame(drawn(100), Circle::nearest, java);
        assertSame(turns(), Circle::nearest, java);
    }

    @Test
    void radians() {
        assertSame(drawn(720), Circle::radians, Math::toRadians);
    }
}
