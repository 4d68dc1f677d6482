package arcomat.symbols;

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
                && unary.node().operator() == arcomat.tree.Expression.UnaryOperator.MINUS) {
            return wholeNumber(unary.operand()).map(value -> -value);
        }
        return Optional.empty();
    }
}
