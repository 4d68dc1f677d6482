package arcomat.lower;

import arcomat.model.Expression.BinaryOperator;
import arcomat.tree.Expression;

/** Operators of the text as operators of the model. */
final class Operators {
    private Operators() {}

    static BinaryOperator binary(Expression.BinaryOperator operator) {
        return switch (operator) {
            case MULTIPLY -> BinaryOperator.MULTIPLY;
            case DIVIDE -> BinaryOperator.DIVIDE;
            case REMAINDER -> BinaryOperator.REMAINDER;
            case ADD -> BinaryOperator.PLUS;
            case SUBTRACT -> BinaryOperator.MINUS;
            case LESS -> BinaryOperator.LESS;
            case LESS_OR_EQUAL -> BinaryOperator.LESS_OR_EQUAL;
            case GREATER -> BinaryOperator.GREATER;
            case GREATER_OR_EQUAL -> BinaryOperator.GREATER_OR_EQUAL;
            case EQUAL -> BinaryOperator.EQUAL;
            case NOT_EQUAL -> BinaryOperator.NOT_EQUAL;
            case AND -> BinaryOperator.AND;
            case OR -> BinaryOperator.OR;
            case IMPLIES -> BinaryOperator.IMPLIES;
            case EQUIVALENT -> BinaryOperator.EQUIVALENT;
        };
    }
}
