package arcomat.semantics.value;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Type.Width;
import arcomat.model.Value;
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.Whole;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * Each message that a port can carry is of the kind of exactly one sample, and each sample is a
 * message that the port can carry.
 */
public class MessageClassesTest {
    private static final Type.EnumType LIGHT =
            new Type.EnumType("T.Light", List.of("red", "green", "off"));
    private static final Type.ClassType PAIR =
            new Type.ClassType(
                    "T.Pair",
                    List.of(
                            new Type.Attribute("lit", new Type.BooleanType()),
                            new Type.Attribute("at", range(1, 2))));

    @Test
    void rangesComparedWithAnyNumbers() {
        for (int low = -3; low <= 3; low++) {
            for (int high = low; high <= 3; high++) {
                List<Value> carried = integers(low, high);
                for (List<Value> values : subsets(integers(-4, 4))) {
                    check(range(low, high), values, true, carried);
                    check(range(low, high), values, false, carried);
                }
            }
        }
    }

    @Test
    void limitsOfIntegers() {
        for (Width width : Width.values()) {
            Type.IntegerType type = Type.IntegerType.of(width);
            List<Value> near = new ArrayList<>(integers(type.low(), type.low() + 3));
            near.addAll(integers(-2, 2));
            near.addAll(integers(type.high() - 3, type.high()));
            List<Value> some =
                    Stream.of(type.low(), type.low() + 1, 0L, type.high() - 1, type.high())
                            .<Value>map(Value.IntegerValue::new)
                            .toList();
            subsets(some).forEach(values -> check(type, values, true, near));
            subsets(some).forEach(values -> check(type, values, false, near));
        }
    }

    @Test
    void characters() {
        List<Value> near = characters("\0\1\2`abcd\ufffd\ufffe\uffff");
        for (List<Value> values : subsets(characters("\0\1ac\ufffe\uffff"))) {
            check(new Type.CharacterType(), values, true, near);
            check(new Type.CharacterType(), values, false, near);
        }
    }

    @Test
    void realsHaveNeighbours() {
        double big = 9007199254740992.0;
        double[] some = {-Double.MAX_VALUE, -1, 0, Double.MIN_VALUE, 1, big, Math.nextUp(big)};
        List<Value> near = new ArrayList<>();
        for (double number : some) {
            near.addAll(reals(number, Math.nextUp(number), Math.nextUp(Math.nextUp(number))));
            if (number > -Double.MAX_VALUE && number != Double.MIN_VALUE) {
                near.addAll(reals(Math.nextDown(number)));
            }
        }
        near.addAll(reals(Double.MAX_VALUE));
        near.addAll(UNUSUAL);
        for (List<Value> values : subsets(reals(some))) {
            check(new Type.RealType(false), values, true, near);
            check(new Type.RealType(false), values, false, near);
        }
        check(new Type.RealType(false), reals(Double.MAX_VALUE), true, near);
        check(new Type.RealType(false), reals(-1e308, 1.7e308), true, near);
        check(new Type.RealType(false), reals(Double.POSITIVE_INFINITY), true, near);
        check(new Type.RealType(false), reals(Double.NEGATIVE_INFINITY, 3), true, near);
    }

    @Test
    void singlesHaveFewerNeighbours() {
        float[] some = {-Float.MAX_VALUE, 0, 0.1f, Math.nextUp(0.1f), 16777216, 16777218, 1e30f};
        List<Value> near = new ArrayList<>();
        List<Value> numbers = new ArrayList<>();
        for (float number : some) {
            numbers.addAll(reals(number));
            near.addAll(reals(number, Math.nextUp(number)));
            if (number > -Float.MAX_VALUE) {
                near.addAll(reals(Math.nextDown(number)));
            }
        }
        near.addAll(reals(Float.MAX_VALUE));
        near.addAll(UNUSUAL);
        for (List<Value> values : subsets(numbers)) {
            check(new Type.RealType(true), values, true, near);
            check(new Type.RealType(true), values, false, near);
        }
    }

    @Test
    void constantsTextsAndObjects() {
        List<Value> lights = SmallType.values(LIGHT).orElseThrow();
        subsets(lights).forEach(values -> check(LIGHT, values, false, lights));
        List<Value> texts = Stream.of("", "a", "aa", "b").map(MessageClassesTest::text).toList();
        for (List<Value> values : subsets(texts)) {
            check(new Type.StringType(), values, false, texts);
        }
        List<Value> pairs = new ArrayList<>();
        for (boolean lit : List.of(false, true)) {
            for (Value at : integers(1, 2)) {
                pairs.add(new Value.ObjectValue(PAIR, List.of(new Value.BooleanValue(lit), at)));
            }
        }
        subsets(pairs).forEach(values -> check(PAIR, values, false, pairs));
    }

    @Test
    void allValuesWhereAllMatter() {
        assertThat(MessageClasses.of(port(range(-2, 1)), false, new Whole()).samples())
                .containsExactlyInAnyOrder(
                        Stream.concat(Stream.of((Value) null), integers(-2, 1).stream())
                                .toArray(Value[]::new));
        assertThat(MessageClasses.of(port(LIGHT), true, new Whole()).samples())
                .isEqualTo(SmallType.values(LIGHT).orElseThrow());
    }

    private static final List<Value> UNUSUAL =
            Stream.of(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, -0.0)
                    .<Value>map(Value.RealValue::new)
                    .toList();

    private static void check(Type type, List<Value> values, boolean ordered, List<Value> carried) {
        Compared look = new Compared(values, ordered);
        MessageClasses kinds = MessageClasses.of(port(type), true, look);
        List<Value> samples = kinds.samples();
        String what = type.name() + " beside " + look;
        assertThat(samples).as(what).doesNotContainNull().allMatch(each -> isIn(type, each));
        assertThat(samples.stream().map(kinds::of)).as(what).doesNotHaveDuplicates();
        assertThat(samples.stream().map(kinds::of)).as(what).allMatch(k -> k < kinds.count());
        for (Value message : carried) {
            List<Value> alike =
                    samples.stream().filter(sample -> areAlike(sample, message, look)).toList();
            assertThat(alike).as(what + " and " + message).hasSize(1);
            assertThat(kinds.of(message)).isEqualTo(kinds.of(alike.get(0)));
        }
        assertThat(MessageClasses.of(port(type), false, look).samples())
                .hasSize(samples.size() + 1);
    }

    private static boolean areAlike(Value one, Value other, Compared look) {
        return look.values().stream()
                .allMatch(
                        value -> {
                            String left = comparison(one, value);
                            String right = comparison(other, value);
                            return look.ordered()
                                    ? left.equals(right)
                                    : left.equals("=") == right.equals("=");
                        });
    }

    /** Java's operators that give true. */
    private static String comparison(Value one, Value other) {
        if (one instanceof Value.RealValue left && other instanceof Value.RealValue right) {
            return (left.value() < right.value() ? "<" : "")
                    + (left.value() == right.value() ? "=" : "")
                    + (left.value() > right.value() ? ">" : "");
        }
        int order = one.compareTo(other);
        return order < 0 ? "<" : order == 0 ? "=" : ">";
    }

    private static boolean isIn(Type type, Value value) {
        if (type instanceof Type.IntegerType integer) {
            long number = ((Value.IntegerValue) value).value();
            return integer.low() <= number && number <= integer.high();
        }
        if (type instanceof Type.RealType real) {
            double number = ((Value.RealValue) value).value();
            return !real.single() || Double.compare((float) number, number) == 0;
        }
        return true;
    }

    private static List<List<Value>> subsets(List<Value> all) {
        return IntStream.range(0, 1 << all.size())
                .mapToObj(
                        bits ->
                                IntStream.range(0, all.size())
                                        .filter(i -> (bits >> i & 1) == 1)
                                        .mapToObj(all::get)
                                        .toList())
                .toList();
    }

    private static Type.IntegerType range(long low, long high) {
        return new Type.IntegerType(Width.INT, low, high, true);
    }

    private static List<Value> integers(long low, long high) {
        return LongStream.rangeClosed(low, high).<Value>mapToObj(Value.IntegerValue::new).toList();
    }

    private static List<Value> reals(double... numbers) {
        return Arrays.stream(numbers).<Value>mapToObj(n -> new Value.RealValue(n + 0.0)).toList();
    }

    private static List<Value> characters(String text) {
        return text.chars().<Value>mapToObj(c -> new Value.CharacterValue((char) c)).toList();
    }

    private static Value text(String text) {
        return new Value.StringValue(text);
    }

    private static Port port(Type type) {
        Span nowhere = new Span(new SourceFile("test", ""), 0, 0);
        return new Port("p", Port.Direction.IN, type, false, 0, false, nowhere);
    }
}
