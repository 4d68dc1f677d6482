package arcomat.analysis.bits;

import static arcomat.semantics.ComponentBuilder.NOWHERE;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.ExpressionText;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Type.Width;
import arcomat.model.Value;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Scope;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** A condition and its threshold are asked about many messages, those beside thresholds first. */
class ThresholdsTest {
    private static final int CONDITIONS = 4_000;
    private static final Type TRUTH = new Type.BooleanType();
    private static final Type DOUBLE = new Type.RealType(false);
    private static final List<Type> READ =
            List.of(
                    DOUBLE,
                    DOUBLE,
                    new Type.RealType(true),
                    Type.IntegerType.of(Width.INT),
                    Type.IntegerType.of(Width.LONG),
                    new Type.IntegerType(Width.INT, -3, 100, true));
    private static final double[] NOTABLE = {
        0,
        -0.0,
        1,
        0.1,
        2,
        -3,
        10,
        0.5,
        1e300,
        -1e-300,
        0x1p53,
        0x1p62,
        Double.MIN_VALUE,
        Double.MAX_VALUE,
        Double.POSITIVE_INFINITY,
        Double.NEGATIVE_INFINITY,
        Double.NaN
    };
    private static final List<BinaryOperator> OPERATORS =
            List.of(
                    BinaryOperator.PLUS,
                    BinaryOperator.MINUS,
                    BinaryOperator.MULTIPLY,
                    BinaryOperator.DIVIDE,
                    BinaryOperator.REMAINDER);
    private static final List<BinaryOperator> COMPARISONS =
            List.of(
                    BinaryOperator.LESS,
                    BinaryOperator.LESS_OR_EQUAL,
                    BinaryOperator.GREATER,
                    BinaryOperator.GREATER_OR_EQUAL,
                    BinaryOperator.EQUAL,
                    BinaryOperator.NOT_EQUAL);

    private final Random random = new Random(7);
    private int simplified;

    @Tag("slow")
    @Test
    void thresholdsAreWhereTheyAre() {
        for (int i = 0; i < CONDITIONS; i++) {
            Port port = port(READ.get(random.nextInt(READ.size())));
            compare(condition(port), port);
        }
        assertThat(simplified).isGreaterThan(CONDITIONS / 4).isLessThan(CONDITIONS);
    }

    private void compare(Expression condition, Port port) {
        Expression threshold = Thresholds.simplified(condition);
        simplified += threshold.equals(condition) ? 0 : 1;
        for (Value message : messages(port.type(), threshold)) {
            assertThat(isTrue(threshold, port, message))
                    .as(
                            "%s, in place of %s, for %s",
                            ExpressionText.of(threshold), ExpressionText.of(condition), message)
                    .isEqualTo(isTrue(condition, port, message));
        }
    }

    private static boolean isTrue(Expression condition, Port port, Value message) {
        return Evaluation.compile(condition, Scope.ofPorts(List.of(port)))
                .isTrue(new Value[] {message}, new Value[0]);
    }

    private static Port port(Type type) {
        return new Port("x", Port.Direction.IN, type, true, 0, false, NOWHERE);
    }

    private Expression condition(Port port) {
        Expression calculated = new Expression.PortRead(port, NOWHERE);
        if (!(port.type() instanceof Type.RealType)) {
            calculated = new Expression.Cast(calculated, DOUBLE, NOWHERE);
        }
        for (int depth = random.nextInt(4); depth > 0; depth--) {
            calculated = operation(calculated);
        }
        Expression with = constant(calculated.type());
        boolean turned = random.nextInt(4) == 0;
        return new Expression.Binary(
                COMPARISONS.get(random.nextInt(COMPARISONS.size())),
                turned ? with : calculated,
                turned ? calculated : with,
                TRUTH,
                NOWHERE);
    }

    private Expression operation(Expression e) {
        Type type = e.type();
        return switch (random.nextInt(12)) {
            case 0 -> new Expression.Unary(Expression.UnaryOperator.NEGATE, e, type, NOWHERE);
            case 1 -> new Expression.Cast(e, new Type.RealType(random.nextBoolean()), NOWHERE);
            case 2 ->
                    new Expression.Cast(
                            new Expression.Cast(e, Type.IntegerType.of(Width.INT), NOWHERE),
                            type,
                            NOWHERE);
            default -> {
                boolean first = random.nextInt(3) == 0;
                Expression with = random.nextInt(8) == 0 ? e : constant(type);
                yield new Expression.Binary(
                        OPERATORS.get(random.nextInt(OPERATORS.size())),
                        first ? with : e,
                        first ? e : with,
                        type,
                        NOWHERE);
            }
        };
    }

    private Expression constant(Type type) {
        double number =
                random.nextInt(3) == 0 ? random.nextGaussian() * 10 : NOTABLE[random.nextInt(17)];
        boolean single = ((Type.RealType) type).single();
        return new Expression.Constant(
                new Value.RealValue(single ? (float) number : number), type, NOWHERE);
    }

    private List<Value> messages(Type type, Expression threshold) {
        List<Double> numbers = new ArrayList<>();
        threshold.visit(
                each -> {
                    if (each instanceof Expression.Constant constant) {
                        addBeside(constant.value(), numbers);
                    }
                });
        for (double each : NOTABLE) {
            numbers.add(each);
            numbers.add(-each);
        }
        numbers.add(Double.longBitsToDouble(random.nextLong()));
        return numbers.stream().map(number -> value(number, type)).toList();
    }

    private static void addBeside(Value value, List<Double> numbers) {
        if (value instanceof Value.RealValue real) {
            numbers.addAll(
                    List.of(
                            real.value(),
                            Math.nextUp(real.value()),
                            Math.nextDown(real.value()),
                            (double) Math.nextUp((float) real.value()),
                            (double) Math.nextDown((float) real.value())));
        } else if (value instanceof Value.IntegerValue whole) {
            numbers.add((double) whole.value() + 1);
            numbers.add((double) whole.value() - 1);
            numbers.add((double) whole.value());
        }
    }

    private static Value value(double number, Type type) {
        if (type instanceof Type.RealType real) {
            return new Value.RealValue(real.single() ? (float) number : number);
        }
        Type.IntegerType whole = (Type.IntegerType) type;
        long cut = Math.max(whole.low(), Math.min(whole.high(), (long) number));
        return new Value.IntegerValue(cut);
    }
}
