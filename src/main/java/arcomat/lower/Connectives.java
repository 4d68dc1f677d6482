package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.source.Span;

import java.util.List;

/** Builds guards out of guards, by the connectives of logic. */
final class Connectives {
    private static final Type BOOLEAN = new Type.BooleanType();

    private Connectives() {}

    /** At least one operand is given. */
    static Expression conjunction(List<Expression> operands) {
        return joined(Expression.BinaryOperator.AND, operands);
    }

    /** At least one operand is given. */
    static Expression disjunction(List<Expression> operands) {
        return joined(Expression.BinaryOperator.OR, operands);
    }

    static Expression not(Expression operand) {
        return new Expression.Unary(Expression.UnaryOperator.NOT, operand, BOOLEAN, operand.span());
    }

    /** What is never true. */
    static Expression never(Span place) {
        return new Expression.Constant(new Value.BooleanValue(false), BOOLEAN, place);
    }

    static Expression equal(Expression left, Expression right) {
        return new Expression.Binary(
                Expression.BinaryOperator.EQUAL, left, right, BOOLEAN, right.span());
    }

    private static Expression joined(
            Expression.BinaryOperator operator, List<Expression> operands) {
        Expression result = operands.get(0);
        for (Expression next : operands.subList(1, operands.size())) {
            result = new Expression.Binary(operator, result, next, BOOLEAN, next.span());
        }
        return result;
    }
}
