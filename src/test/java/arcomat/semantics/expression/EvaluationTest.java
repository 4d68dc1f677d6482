package arcomat.semantics.expression;

import static arcomat.semantics.ComponentBuilder.NOWHERE;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Type.Width;
import arcomat.model.Value;
import arcomat.semantics.ComponentBuilder;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

import org.junit.jupiter.api.Test;

import java.util.List;

/** Java's own arithmetic is the expectation. */
class EvaluationTest {
    private static final Type INT = Type.IntegerType.of(Width.INT);
    private static final Type LONG = Type.IntegerType.of(Width.LONG);
    private static final Type FLOAT = new Type.RealType(true);
    private static final Type DOUBLE = new Type.RealType(false);
    private static final Type STRING = new Type.StringType();

    private static Value evaluate(Expression expression) {
        return Evaluation.compile(
                        expression, new Scope(ComponentBuilder.component("C").build(), List.of()))
                .evaluate(new Value[0], new Value[0]);
    }

    private static Expression whole(Type type, long value) {
        return new Expression.Constant(new Value.IntegerValue(value), type, NOWHERE);
    }

    private static Expression real(Type type, double value) {
        return new Expression.Constant(new Value.RealValue(value), type, NOWHERE);
    }

    private static long whole(BinaryOperator operator, Type type, long a, long b) {
        Expression e =
                new Expression.Binary(operator, whole(type, a), whole(type, b), type, NOWHERE);
        return ((Value.IntegerValue) evaluate(e)).value();
    }

    private static double real(BinaryOperator operator, Type type, double a, double b) {
        Expression e = new Expression.Binary(operator, real(type, a), real(type, b), type, NOWHERE);
        return ((Value.RealValue) evaluate(e)).value();
    }

    @Property(seed = "1")
    void intsWrapAround(@ForAll int a, @ForAll int b) {
        assertThat(whole(BinaryOperator.PLUS, INT, a, b)).isEqualTo(a + b);
        assertThat(whole(BinaryOperator.MINUS, INT, a, b)).isEqualTo(a - b);
        assertThat(whole(BinaryOperator.MULTIPLY, INT, a, b)).isEqualTo(a * b);
        if (b != 0) {
            assertThat(whole(BinaryOperator.DIVIDE, INT, a, b)).isEqualTo(a / b);
            assertThat(whole(BinaryOperator.REMAINDER, INT, a, b)).isEqualTo(a % b);
        }
    }

    @Property(seed = "2")
    void longsWrapAround(@ForAll long a, @ForAll long b) {
        assertThat(whole(BinaryOperator.PLUS, LONG, a, b)).isEqualTo(a + b);
        assertThat(whole(BinaryOperator.MULTIPLY, LONG, a, b)).isEqualTo(a * b);
        if (b != 0) {
            assertThat(whole(BinaryOperator.DIVIDE, LONG, a, b)).isEqualTo(a / b);
        }
    }

    @Property(seed = "3")
    void realsAreSingleOrDouble(@ForAll float a, @ForAll float b) {
        assertThat(real(BinaryOperator.PLUS, FLOAT, a, b)).isEqualTo(Double.valueOf(a + b));
        assertThat(real(BinaryOperator.MULTIPLY, FLOAT, a, b)).isEqualTo(Double.valueOf(a * b));
        assertThat(real(BinaryOperator.DIVIDE, FLOAT, a, b)).isEqualTo(Double.valueOf(a / b));
        assertThat(real(BinaryOperator.DIVIDE, DOUBLE, a, b))
                .isEqualTo(Double.valueOf((double) a / b));
    }

    @Property(seed = "4")
    void castsAreJavas(@ForAll double real, @ForAll long whole) {
        assertThat(cast(real(DOUBLE, real), INT)).isEqualTo(new Value.IntegerValue((int) real));
        assertThat(cast(real(DOUBLE, real), LONG)).isEqualTo(new Value.IntegerValue((long) real));
        assertThat(cast(real(DOUBLE, real), Type.IntegerType.of(Width.BYTE)))
                .isEqualTo(new Value.IntegerValue((byte) real));
        assertThat(cast(whole(LONG, whole), Type.IntegerType.of(Width.SHORT)))
                .isEqualTo(new Value.IntegerValue((short) whole));
        assertThat(cast(whole(LONG, whole), new Type.CharacterType()))
                .isEqualTo(new Value.CharacterValue((char) whole));
        assertThat(cast(whole(LONG, whole), FLOAT)).isEqualTo(new Value.RealValue((float) whole));
    }

    private static Value cast(Expression operand, Type type) {
        return evaluate(new Expression.Cast(operand, type, NOWHERE));
    }

    @Test
    void negationWrapsAroundToo() {
        Expression least = whole(INT, Integer.MIN_VALUE);
        assertThat(
                        evaluate(
                                new Expression.Unary(
                                        Expression.UnaryOperator.NEGATE, least, INT, NOWHERE)))
                .isEqualTo(new Value.IntegerValue(Integer.MIN_VALUE));
    }

    @Test
    void notANumberEqualsNothing() {
        Expression nan = real(DOUBLE, Double.NaN);
        Expression equal =
                new Expression.Binary(
                        BinaryOperator.EQUAL, nan, nan, ComponentBuilder.BOOLEAN, NOWHERE);
        assertThat(evaluate(equal)).isEqualTo(new Value.BooleanValue(false));
    }

    @Test
    void stringsAreJoinedAsJavaDoes() {
        Expression text = new Expression.Constant(new Value.StringValue("x"), STRING, NOWHERE);
        Expression character =
                new Expression.Constant(
                        new Value.CharacterValue('c'), new Type.CharacterType(), NOWHERE);
        Expression tenth = real(FLOAT, 0.1f);
        Expression joined =
                new Expression.Binary(
                        BinaryOperator.PLUS,
                        new Expression.Binary(
                                BinaryOperator.PLUS, text, character, STRING, NOWHERE),
                        tenth,
                        STRING,
                        NOWHERE);
        assertThat(evaluate(joined)).isEqualTo(new Value.StringValue("x" + 'c' + 0.1f));
    }
}
