package arcomat.semantics;

import static arcomat.semantics.ComponentBuilder.range;
import static arcomat.semantics.ComponentBuilder.value;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.value.MessageClassesTest;
import arcomat.semantics.value.SmallType;
import arcomat.semantics.value.TooManyMessages;
import arcomat.semantics.value.ValueGaps;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.stream.DoubleStream;

/**
 * Which values are tried, and what is said where there are too many. {@link MessageClassesTest}
 * says why they are enough.
 */
class SamplesTest {
    private static final Type.RealType DOUBLE = new Type.RealType(false);
    private static final Type.RealType FLOAT = new Type.RealType(true);

    private static List<Value> reals(double... numbers) {
        return DoubleStream.of(numbers).<Value>mapToObj(Value.RealValue::new).toList();
    }

    private static List<Value> beside(Type type, double... numbers) {
        return new ValueGaps(type, reals(numbers)).gaps();
    }

    @Test
    void betweenTwoNumbersTheMiddleIsTried() {
        assertThat(beside(DOUBLE, 1, 2)).isEqualTo(reals(0, 1.5, 3));
        assertThat(beside(DOUBLE, -1e308, 1e308)).contains(new Value.RealValue(0));
    }

    @Test
    void neighboursHaveNothingBetweenThem() {
        assertThat(beside(DOUBLE, 1, Math.nextUp(1.0))).isEqualTo(reals(0, 2));
        assertThat(beside(FLOAT, 1, Math.nextUp(1f))).isEqualTo(reals(0, 2));
        assertThat(beside(DOUBLE, 1, Math.nextUp(1f))).hasSize(3);
    }

    @Test
    void infinityIsTheLastResort() {
        assertThat(beside(DOUBLE, Double.NEGATIVE_INFINITY, 0, Double.POSITIVE_INFINITY))
                .allSatisfy(each -> assertThat(((Value.RealValue) each).value()).isFinite())
                .hasSize(2);
        assertThat(beside(DOUBLE, Double.MAX_VALUE))
                .contains(new Value.RealValue(Double.POSITIVE_INFINITY));
    }

    @Test
    void aRangeOfOneValueIsSmall() {
        assertThat(SmallType.values(range(3, 3))).contains(List.of(new Value.IntegerValue(3)));
        assertThat(SmallType.values(range(0, SmallType.MOST - 1)).orElseThrow())
                .hasSize(SmallType.MOST);
        assertThat(SmallType.values(range(0, SmallType.MOST))).isEmpty();
        assertThat(SmallType.values(ComponentBuilder.INTEGER)).isEmpty();
        assertThat(SmallType.values(Type.IntegerType.of(Type.Width.LONG))).isEmpty();
    }

    @Test
    void valuesHaveAnOrder() {
        assertThat(value(range(0, 20), "9").compareTo(value(range(0, 20), "10"))).isNegative();
        assertThat(
                        value(ComponentBuilder.BOOLEAN, "false")
                                .compareTo(value(ComponentBuilder.BOOLEAN, "true")))
                .isNegative();
        assertThat(new Value.CharacterValue('\n').compareTo(new Value.CharacterValue('Z')))
                .isNegative();
        assertThat(
                        value(ComponentBuilder.DISTANCE, "tooClose")
                                .compareTo(value(ComponentBuilder.DISTANCE, "clear")))
                .isPositive();
    }

    @Test
    void onlyARangeHelpsWhereThereAreTooManyNumbers() {
        assertThat(tooMany(ComponentBuilder.INTEGER))
                .isEqualTo(
                        "every value of port 'x' matters, and Integer has too many to try; "
                                + "give it a range of at most 4096 values");
        assertThat(tooMany(DOUBLE))
                .isEqualTo("every value of port 'x' matters, and Double has too many to try");
    }

    private static String tooMany(Type type) {
        Port port = ComponentBuilder.component("C").in(type, "x").port("x");
        return TooManyMessages.on(port).getMessage();
    }
}
