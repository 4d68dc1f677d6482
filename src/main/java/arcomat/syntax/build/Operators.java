package arcomat.syntax.build;

import arcomat.tree.Expression.BinaryOperator;
import arcomat.tree.Expression.UnaryOperator;

import org.antlr.v4.runtime.Token;

/** From tokens to operators. */
final class Operators {
    private static final BinaryOperator[] BINARY = BinaryOperator.values();
    private static final UnaryOperator[] UNARY = UnaryOperator.values();

    private Operators() {}

    static BinaryOperator binary(Token token) {
        String symbol = token.getText();
        for (BinaryOperator operator : BINARY) {
            if (operator.symbol().equals(symbol)) {
                return operator;
            }
        }
        throw new AssertionError(symbol);
    }

    static UnaryOperator unary(Token token) {
        String symbol = token.getText();
        for (UnaryOperator operator : UNARY) {
            if (operator.symbol().equals(symbol)) {
                return operator;
            }
        }
        throw new AssertionError(symbol);
    }
}
