package arcomat.symbols.expressions;

import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Expression;

import java.util.Optional;

/** What binary operators ask of their operands, and what they yield. */
final class OperatorTyping {
    /** The type in which the operands meet, and the type of the whole. */
    record Result(TypeSymbol operands, TypeSymbol result) {}

    private OperatorTyping() {}

    static Result type(
            Expression.Binary node,
            TypedExpression left,
            TypedExpression right,
            ProblemSink problems) {
        TypeSymbol a = left.type();
        TypeSymbol b = right.type();
        boolean yieldsBoolean = yieldsBoolean(node.operator());
        if (a.isErroneous() || b.isErroneous()) {
            return new Result(
                    UnknownType.UNKNOWN, yieldsBoolean ? BuiltinType.BOOLEAN : UnknownType.UNKNOWN);
        }
        Optional<TypeSymbol> operands = operands(node.operator(), a, b);
        if (operands.isEmpty()) {
            problems.report(
                    ExpressionProblem.Kind.OPERAND_TYPE, node, message(node.operator(), a, b));
            return new Result(
                    UnknownType.UNKNOWN, yieldsBoolean ? BuiltinType.BOOLEAN : UnknownType.UNKNOWN);
        }
        if (dividesByZero(node.operator(), right, operands.get())) {
            problems.report(
                    ExpressionProblem.Kind.DIVISION_BY_ZERO,
                    node.right(),
                    "division by zero would stop the run; correct the divisor");
        }
        return new Result(operands.get(), yieldsBoolean ? BuiltinType.BOOLEAN : operands.get());
    }

    private static boolean yieldsBoolean(Expression.BinaryOperator operator) {
        return switch (operator) {
            case MULTIPLY, DIVIDE, REMAINDER, ADD, SUBTRACT -> false;
            case LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL -> true;
            case EQUAL, NOT_EQUAL, AND, OR, IMPLIES, EQUIVALENT -> true;
        };
    }

    private static Optional<TypeSymbol> operands(
            Expression.BinaryOperator operator, TypeSymbol a, TypeSymbol b) {
        return switch (operator) {
            case ADD -> a == BuiltinType.STRING && b == a ? Optional.of(a) : numeric(a, b);
            case MULTIPLY, DIVIDE, REMAINDER, SUBTRACT -> numeric(a, b);
            case LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL -> numeric(a, b);
            case AND, OR, IMPLIES, EQUIVALENT ->
                    a.isBoolean() && b.isBoolean() ? Optional.of(a) : Optional.empty();
            case EQUAL, NOT_EQUAL -> a.isNumeric() ? numeric(a, b) : same(a, b);
        };
    }

    private static Optional<TypeSymbol> numeric(TypeSymbol a, TypeSymbol b) {
        return a.isNumeric() && b.isNumeric()
                ? Optional.of(TypeRules.promoted(a, b))
                : Optional.empty();
    }

    private static Optional<TypeSymbol> same(TypeSymbol a, TypeSymbol b) {
        return a.equals(b) ? Optional.of(a) : Optional.empty();
    }

    private static boolean dividesByZero(
            Expression.BinaryOperator operator, TypedExpression right, TypeSymbol operands) {
        boolean divides =
                operator == Expression.BinaryOperator.DIVIDE
                        || operator == Expression.BinaryOperator.REMAINDER;
        return divides
                && operands.isIntegral()
                && ConstantFolding.computed(right).filter(v -> v == 0).isPresent();
    }

    private static String message(Expression.BinaryOperator operator, TypeSymbol a, TypeSymbol b) {
        String types = a.text() + " and " + b.text();
        return switch (operator) {
            case EQUAL, NOT_EQUAL ->
                    "values of " + types + " cannot be compared; they are never equal";
            case AND, OR, IMPLIES, EQUIVALENT ->
                    "'" + operator.symbol() + "' needs two Booleans, not " + types;
            case ADD -> "'+' needs two numbers or two strings, not " + types;
            case MULTIPLY,
                    DIVIDE,
                    REMAINDER,
                    SUBTRACT,
                    LESS,
                    LESS_OR_EQUAL,
                    GREATER,
                    GREATER_OR_EQUAL ->
                    "'" + operator.symbol() + "' needs two numbers, not " + types;
        };
    }
}
