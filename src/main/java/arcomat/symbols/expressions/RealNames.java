package arcomat.symbols.expressions;

import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;
import arcomat.tree.Expression.UnaryOperator;

import java.util.Optional;

/**
 * Numbers of floating point that have no literal: {@code NaN}, {@code Infinity} and {@code
 * -Infinity}. Models compute them, if they must; stream tests have to name them.
 */
final class RealNames {
    private RealNames() {}

    /** The number, where one is expected and its name is written. */
    static Optional<TypedExpression> type(Expression expression, TypeSymbol expected) {
        if (!(expected.base() instanceof BuiltinType type) || !type.isReal()) {
            return Optional.empty();
        }
        if (expression instanceof Expression.Unary unary
                && unary.operator() == UnaryOperator.MINUS) {
            return value(unary.operand())
                    .map(value -> new TypedExpression.Literal(expression, -value, type));
        }
        return value(expression).map(value -> new TypedExpression.Literal(expression, value, type));
    }

    private static Optional<Double> value(Expression expression) {
        if (!(expression instanceof Expression.Reference reference)) {
            return Optional.empty();
        }
        return switch (reference.name().text()) {
            case "NaN" -> Optional.of(Double.NaN);
            case "Infinity" -> Optional.of(Double.POSITIVE_INFINITY);
            default -> Optional.empty();
        };
    }
}
