package arcomat.analysis.automaton.trap;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Type.Width;
import arcomat.model.Value;

/**
 * Sums and differences of numbers of one type, as Java has them: what is narrower than an int is
 * computed as one (<i>Java Language Specification</i>, 5.6), and does not wrap around before.
 */
final class Sums {
    private Sums() {}

    /** The whole number at some distance, of the same width; that may wrap around. */
    static Expression beside(Expression number, Type.IntegerType type, long distance) {
        Type computed = computed(type);
        Expression constant =
                new Expression.Constant(new Value.IntegerValue(distance), computed, number.span());
        Expression sum = binary(BinaryOperator.PLUS, number, constant, computed);
        Type narrow = Type.IntegerType.of(type.width());
        return narrow.equals(computed) ? sum : new Expression.Cast(sum, narrow, number.span());
    }

    static Expression difference(Expression left, Expression right) {
        return binary(BinaryOperator.MINUS, left, right, computed(left.type()));
    }

    private static Expression binary(
            BinaryOperator operator, Expression left, Expression right, Type type) {
        return new Expression.Binary(operator, left, right, type, left.span());
    }

    /** A range makes no difference. */
    private static Type computed(Type type) {
        if (!(type instanceof Type.IntegerType integer)) {
            return type;
        }
        return Type.IntegerType.of(integer.width() == Width.LONG ? Width.LONG : Width.INT);
    }
}
