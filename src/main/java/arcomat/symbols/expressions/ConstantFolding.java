package arcomat.symbols.expressions;

import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression.UnaryOperator;

import java.util.Optional;

/** The values of expressions that need no run. */
public final class ConstantFolding {
    private ConstantFolding() {}

    /** The value of a whole number made of literals, minus signs and parentheses. */
    public static Optional<Long> wholeNumber(TypedExpression expression) {
        if (expression instanceof TypedExpression.Literal literal
                && literal.value() instanceof Long value) {
            return Optional.of(value);
        }
        if (expression instanceof TypedExpression.Unary unary
                && unary.node().operator() == UnaryOperator.MINUS) {
            return wholeNumber(unary.operand()).map(value -> -value);
        }
        return Optional.empty();
    }

    /**
     * The value of a whole number that is also computed: sums, products and the like, in the
     * arithmetic of the operands' type, where a character counts as its number. Empty also for a
     * division by zero.
     */
    public static Optional<Long> computed(TypedExpression expression) {
        if (expression instanceof TypedExpression.Unary unary
                && unary.node().operator() == UnaryOperator.MINUS) {
            return computed(unary.operand()).map(value -> wrapped(-value, unary.type()));
        }
        if (expression instanceof TypedExpression.Binary binary
                && binary.operandType().base() instanceof BuiltinType type
                && type.isWhole()) {
            return computed(binary.left())
                    .flatMap(l -> computed(binary.right()).flatMap(r -> apply(binary, l, r)))
                    .map(value -> wrapped(value, type));
        }
        return wholeNumber(expression).or(() -> character(expression));
    }

    private static Optional<Long> character(TypedExpression expression) {
        return expression instanceof TypedExpression.Literal literal
                        && literal.value() instanceof Character character
                ? Optional.of((long) character)
                : Optional.empty();
    }

    private static Optional<Long> apply(TypedExpression.Binary binary, long left, long right) {
        return switch (binary.node().operator()) {
            case ADD -> Optional.of(left + right);
            case SUBTRACT -> Optional.of(left - right);
            case MULTIPLY -> Optional.of(left * right);
            case DIVIDE -> right == 0 ? Optional.empty() : Optional.of(left / right);
            case REMAINDER -> right == 0 ? Optional.empty() : Optional.of(left % right);
            case LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL -> Optional.empty();
            case EQUAL, NOT_EQUAL, AND, OR, IMPLIES, EQUIVALENT -> Optional.empty();
        };
    }

    private static long wrapped(long value, TypeSymbol type) {
        return type.base() == BuiltinType.LONG ? value : (int) value;
    }
}
