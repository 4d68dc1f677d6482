package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;

/**
 * One of two values, as a condition decides. Where one is the other with something added, the sum
 * stays one, and what is added is the number or zero: so a counter is said once, not twice.
 */
final class Alternative {
    private Alternative() {}

    static Expression of(Expression condition, Expression then, Expression otherwise) {
        if (then.equals(otherwise)) {
            return then;
        }
        if (adds(then, otherwise)) {
            Expression.Binary sum = (Expression.Binary) then;
            return sum(sum, choice(condition, sum.right(), zero(sum)));
        }
        if (adds(otherwise, then)) {
            Expression.Binary sum = (Expression.Binary) otherwise;
            return sum(sum, choice(condition, zero(sum), sum.right()));
        }
        return choice(condition, then, otherwise);
    }

    /** Whether a value is the sum of another one and something else, or the difference. */
    private static boolean adds(Expression value, Expression base) {
        return value instanceof Expression.Binary sum
                && (sum.operator() == BinaryOperator.PLUS || sum.operator() == BinaryOperator.MINUS)
                && sum.type() instanceof Type.IntegerType
                && sum.right().type() instanceof Type.IntegerType
                && isSame(sum.left(), base);
    }

    /** Whether both are the same text, or read the same variable at different places. */
    private static boolean isSame(Expression one, Expression other) {
        return one.equals(other)
                || one instanceof Expression.VariableRead read
                        && other instanceof Expression.VariableRead again
                        && read.variable().equals(again.variable());
    }

    private static Expression sum(Expression.Binary sum, Expression added) {
        return new Expression.Binary(sum.operator(), sum.left(), added, sum.type(), sum.span());
    }

    private static Expression zero(Expression.Binary sum) {
        return new Expression.Constant(
                new Value.IntegerValue(0), sum.right().type(), sum.right().span());
    }

    private static Expression choice(Expression condition, Expression then, Expression otherwise) {
        return new Expression.Conditional(
                condition, then, otherwise, then.type(), condition.span());
    }
}
