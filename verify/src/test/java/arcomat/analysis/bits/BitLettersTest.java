package arcomat.analysis.bits;

import static arcomat.semantics.ComponentBuilder.NOWHERE;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Type.Width;
import arcomat.model.Value;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.value.GivenUp;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;

/**
 * The interpreter is the expectation: circuits give what it gives, and letters are what it says.
 */
class BitLettersTest {
    private static final Type TRUTH = new Type.BooleanType();
    private static final Type INT = Type.IntegerType.of(Width.INT);
    private static final Type LONG = Type.IntegerType.of(Width.LONG);
    private static final Type DOUBLE = new Type.RealType(false);
    private static final Type SINGLE = new Type.RealType(true);
    private static final List<Type> NUMBERS = List.of(INT, INT, LONG, DOUBLE, DOUBLE, SINGLE);
    private static final List<Type> TARGETS =
            List.of(
                    Type.IntegerType.of(Width.BYTE),
                    Type.IntegerType.of(Width.SHORT),
                    INT,
                    LONG,
                    DOUBLE,
                    SINGLE,
                    new Type.CharacterType());
    private static final List<Port> PORTS =
            List.of(
                    port("a", INT),
                    port("b", INT),
                    port("l", LONG),
                    port("c", new Type.CharacterType()),
                    port("s", Type.IntegerType.of(Width.SHORT)),
                    port("d", DOUBLE),
                    port("f", SINGLE),
                    port("t", TRUTH));
    private static final double[] NOTABLE_REALS = {
        0,
        -0.0,
        0.5,
        0.1,
        1,
        -3,
        1e10,
        0x1p53 + 2,
        Double.MIN_VALUE,
        Double.MAX_VALUE,
        Double.NaN,
        Double.NEGATIVE_INFINITY
    };
    private static final long[] NOTABLE = {
        0, 1, -1, 2, 3, 7, -8, 255, 65_536, Integer.MAX_VALUE, Integer.MIN_VALUE
    };

    private static final List<BinaryOperator> REAL_OPERATORS =
            List.of(
                    BinaryOperator.PLUS,
                    BinaryOperator.MINUS,
                    BinaryOperator.MULTIPLY,
                    BinaryOperator.DIVIDE);
    private static final List<BinaryOperator> OPERATORS =
            Stream.concat(REAL_OPERATORS.stream(), Stream.of(BinaryOperator.REMAINDER)).toList();

    private static Port port(String name, Type type) {
        return new Port(name, Port.Direction.IN, type, false, 0, false, NOWHERE);
    }

    private static Expression number(long value, Type type) {
        return new Expression.Constant(new Value.IntegerValue(value), type, NOWHERE);
    }

    private static Expression read(int port) {
        return new Expression.PortRead(PORTS.get(port), NOWHERE);
    }

    private static Expression binary(
            BinaryOperator operator, Expression left, Expression right, Type type) {
        return new Expression.Binary(operator, left, right, type, NOWHERE);
    }

    @Tag("slow")
    @Property(tries = 150, seed = "1")
    void circuitsGiveWhatTheInterpreterGives(@ForAll long seed) {
        Random random = new Random(seed);
        Value[] letter =
                PORTS.stream().map(port -> value(port.type(), random)).toArray(Value[]::new);
        Type type = random.nextInt(3) == 0 ? TRUTH : pick(NUMBERS, random);
        Expression e = expression(type, 2, random);
        Value expected;
        try {
            expected = Evaluation.compile(e, Scope.ofPorts(PORTS)).evaluate(letter, new Value[0]);
        } catch (Fault divisionByZero) {
            return;
        }
        assertThat(isPossible(letter, e, expected, true)).as("%s of %s", e, expected).isTrue();
        assertThat(isPossible(letter, e, expected, false)).as("%s of another", e).isFalse();
    }

    /** Whether an expression of a letter can have a value, or can have another one. */
    private static boolean isPossible(Value[] letter, Expression e, Value value, boolean just) {
        BitLetters letters = new BitLetters(PORTS, () -> false);
        for (int port = 0; port < letter.length; port++) {
            letters.claim(letters.is(read(port), letter[port]));
        }
        int is = letters.is(e, value);
        letters.claim(just ? is : -is);
        Optional<Value[]> found = letters.find();
        found.ifPresent(each -> assertThat(each).containsExactly(letter));
        return found.isPresent();
    }

    private static Value value(Type type, Random random) {
        if (type.equals(TRUTH)) {
            return new Value.BooleanValue(random.nextBoolean());
        }
        if (type instanceof Type.RealType real) {
            double number =
                    random.nextBoolean()
                            ? NOTABLE_REALS[random.nextInt(NOTABLE_REALS.length)]
                            : Double.longBitsToDouble(random.nextLong());
            return new Value.RealValue(real.single() ? (float) number : number);
        }
        long number =
                random.nextBoolean() ? NOTABLE[random.nextInt(NOTABLE.length)] : random.nextLong();
        if (type instanceof Type.CharacterType) {
            return new Value.CharacterValue((char) number);
        }
        return new Value.IntegerValue(
                switch (((Type.IntegerType) type).width()) {
                    case BYTE -> (byte) number;
                    case SHORT -> (short) number;
                    case INT -> (int) number;
                    case LONG -> number;
                });
    }

    private static Expression expression(Type type, int depth, Random random) {
        if (type.equals(TRUTH)) {
            return condition(depth, random);
        }
        if (depth == 0) {
            boolean constant = random.nextInt(3) == 0;
            Expression leaf =
                    constant
                            ? new Expression.Constant(value(type, random), type, NOWHERE)
                            : read(random.nextInt(PORTS.size() - 1));
            return leaf.type().equals(type) ? leaf : new Expression.Cast(leaf, type, NOWHERE);
        }
        return switch (random.nextInt(8)) {
            case 0 ->
                    new Expression.Unary(
                            type instanceof Type.RealType || random.nextBoolean()
                                    ? Expression.UnaryOperator.NEGATE
                                    : Expression.UnaryOperator.COMPLEMENT,
                            expression(type, depth - 1, random),
                            type,
                            NOWHERE);
            case 1 ->
                    new Expression.Conditional(
                            condition(depth - 1, random),
                            expression(type, depth - 1, random),
                            expression(type, depth - 1, random),
                            type,
                            NOWHERE);
            case 2 ->
                    new Expression.Cast(
                            new Expression.Cast(
                                    expression(pick(NUMBERS, random), depth - 1, random),
                                    pick(TARGETS, random),
                                    NOWHERE),
                            type,
                            NOWHERE);
            default ->
                    binary(
                            type instanceof Type.RealType
                                    ? pick(REAL_OPERATORS, random)
                                    : pick(OPERATORS, random),
                            expression(type, depth - 1, random),
                            expression(type, depth - 1, random),
                            type);
        };
    }

    private static Expression condition(int depth, Random random) {
        if (depth == 0) {
            return read(PORTS.size() - 1);
        }
        if (random.nextInt(5) == 0) {
            return new Expression.Unary(
                    Expression.UnaryOperator.NOT, condition(depth - 1, random), TRUTH, NOWHERE);
        }
        BinaryOperator[] all = BinaryOperator.values();
        int first = BinaryOperator.LESS.ordinal();
        BinaryOperator operator = all[first + random.nextInt(all.length - first)];
        boolean ofTruths = operator.ordinal() >= BinaryOperator.AND.ordinal();
        Type type = ofTruths ? TRUTH : pick(NUMBERS, random);
        return binary(
                operator,
                expression(type, depth - 1, random),
                expression(type, depth - 1, random),
                TRUTH);
    }

    private static <T> T pick(List<T> all, Random random) {
        return all.get(random.nextInt(all.size()));
    }

    /** 49 has four roots among numbers of 32 bits, 50 has none, and 3 neither. */
    @Test
    void rootsAreFound() {
        Expression square = binary(BinaryOperator.MULTIPLY, read(0), read(0), INT);
        assertThat(solutions(square, 49))
                .containsExactlyInAnyOrder(7, -7, 7 + Integer.MIN_VALUE, -7 + Integer.MIN_VALUE);
        assertThat(solutions(square, 50)).isEmpty();
        assertThat(solutions(square, 3)).isEmpty();
    }

    private static List<Integer> solutions(Expression e, long result) {
        List<Port> ports = PORTS.subList(0, 1);
        BitLetters letters = new BitLetters(ports, () -> false);
        letters.claim(letters.is(e, new Value.IntegerValue(result)));
        List<Integer> found = new ArrayList<>();
        for (Optional<Value[]> next = letters.find(); next.isPresent(); next = letters.find()) {
            Value value = next.get()[0];
            found.add((int) value.whole());
            letters.claim(-letters.is(read(0), value));
        }
        return found;
    }

    @Test
    void givesUpWhenItIsToldTo() {
        BitLetters letters = new BitLetters(PORTS, () -> true);
        Expression product = binary(BinaryOperator.MULTIPLY, read(0), read(1), INT);
        letters.claim(letters.is(product, new Value.IntegerValue(1_000_003)));
        letters.claim(
                letters.truth(binary(BinaryOperator.GREATER, read(0), number(1, INT), TRUTH)));
        letters.claim(
                letters.truth(binary(BinaryOperator.GREATER, read(1), number(1, INT), TRUTH)));
        assertThatThrownBy(letters::find).isInstanceOf(GivenUp.class);
    }

    @Test
    void circuitsDoNotGrowForEver() {
        BitLetters letters = new BitLetters(PORTS, () -> false);
        Expression number = read(2);
        for (int i = 0; i < 20; i++) {
            number = binary(BinaryOperator.DIVIDE, read(2), number, LONG);
        }
        Expression large = number;
        assertThatThrownBy(() -> letters.areSame(large, read(2))).isInstanceOf(GivenUp.class);
    }

    /** Of objects within objects, too: each is one of its own type. */
    @Test
    void objectsAreTheirAttributes() {
        Type text = new Type.StringType();
        Type few = new Type.IntegerType(Width.INT, 2, 3, true);
        Type.ClassType inner = object("I", text, few, DOUBLE);
        Type.ClassType outer = object("O", INT, inner, TRUTH);
        Port one = port("one", outer);
        Port two = port("two", outer);
        BitLetters letters = new BitLetters(List.of(one, two), () -> false);
        letters.claim(-letters.areSame(whole(one), whole(two)));
        letters.claim(same(letters, INT, one, two, 0));
        letters.claim(same(letters, text, one, two, 1, 0));
        letters.claim(same(letters, DOUBLE, one, two, 1, 2));
        letters.claim(same(letters, TRUTH, one, two, 2));
        Value[] found = letters.find().orElseThrow();
        assertThat(List.of(number(found[0]), number(found[1]))).containsExactlyInAnyOrder(2L, 3L);
        letters.claim(same(letters, few, one, two, 1, 1));
        assertThat(letters.find()).isEmpty();
    }

    private static Type.ClassType object(String name, Type... types) {
        return new Type.ClassType(
                name, Stream.of(types).map(type -> new Type.Attribute("a", type)).toList());
    }

    private static Expression whole(Port port) {
        return new Expression.PortRead(port, NOWHERE);
    }

    private static int same(BitLetters letters, Type type, Port one, Port two, int... path) {
        return letters.areSame(part(one, type, path), part(two, type, path));
    }

    private static Expression part(Port port, Type type, int... path) {
        Expression part = whole(port);
        for (int index : path) {
            Type own = ((Type.ClassType) part.type()).attributes().get(index).type();
            part = new Expression.AttributeRead(part, index, own, NOWHERE);
        }
        assertThat(part.type()).isEqualTo(type);
        return part;
    }

    /** The second attribute of the second one. */
    private static long number(Value object) {
        Value inner = ((Value.ObjectValue) object).attributes().get(1);
        return ((Value.ObjectValue) inner).attributes().get(1).whole();
    }

    @Test
    void remaindersOfRealNumbersAreFoundOut() {
        BitLetters letters = new BitLetters(List.of(), Map.of(), 2, () -> false);
        Type real = new Type.RealType(false);
        Expression half = new Expression.Constant(new Value.RealValue(0.5), real, NOWHERE);
        Expression rest = binary(BinaryOperator.REMAINDER, half, half, real);
        letters.claim(-letters.areSame(rest, half));
        assertThat(letters.find()).isPresent();
        letters.claim(-letters.is(rest, new Value.RealValue(0)));
        assertThat(letters.find()).isEmpty();
    }

    /**
     * A number that is whole is no number of floating point, and none of those of 32 bits is 0.1.
     */
    @Test
    void numbersOfOtherTypesHaveNoBits() {
        BitLetters letters = new BitLetters(List.of(), () -> false);
        Type single = new Type.RealType(true);
        Expression tenth = new Expression.Constant(new Value.RealValue(0.1), single, NOWHERE);
        assertThatThrownBy(() -> letters.areSame(tenth, tenth)).isInstanceOf(GivenUp.class);
        Expression one = new Expression.Constant(new Value.RealValue(1), single, NOWHERE);
        assertThatThrownBy(() -> letters.areSame(one, number(1, INT))).isInstanceOf(GivenUp.class);
        assertThatThrownBy(() -> letters.is(one, new Value.IntegerValue(1)))
                .isInstanceOf(GivenUp.class);
    }
}
