package arcomat.symbols.expressions;

import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Expression;

import java.util.Optional;

/** What operators ask of their operands, and what they yield. */
final class OperatorTyping {
    /** The type in which the operands meet, and the type of the whole. */
    record Result(TypeSymbol operands, TypeSymbol result) {}

    private OperatorTyping() {}

    static Result type(
            Expression.Binary node,
            TypedExpression left,
            TypedExpression right,
            Problems problems) {
        TypeSymbol a = left.type();
        TypeSymbol b = right.type();
        boolean judged = !a.isErroneous() && !b.isErroneous();
        Optional<TypeSymbol> meet = judged ? operands(node.operator(), a, b) : Optional.empty();
        if (judged && meet.isEmpty()) {
            problems.report(Kind.OPERAND_TYPE, node, message(node.operator(), a, b));
        }
        TypeSymbol operands = meet.orElse(UnknownType.UNKNOWN);
        if (dividesByZero(node.operator(), right, operands)) {
            problems.report(
                    Kind.DIVISION_BY_ZERO,
                    node.right(),
                    "division by zero would stop the run; correct the divisor");
        }
        return new Result(
                operands, yieldsBoolean(node.operator()) ? BuiltinType.BOOLEAN : operands);
    }

    /** The type of the whole. */
    static TypeSymbol type(Expression.Unary node, TypeSymbol operand, Problems problems) {
        if (node.operator() == Expression.UnaryOperator.NOT) {
            check(operand.isBoolean(), "a Boolean", node, operand, problems);
            return operand.isErroneous() || operand.isBoolean()
                    ? BuiltinType.BOOLEAN
                    : UnknownType.UNKNOWN;
        }
        boolean whole = node.operator() == Expression.UnaryOperator.COMPLEMENT;
        boolean applies = whole ? operand.isIntegral() : operand.isNumeric();
        check(applies, whole ? "a whole number" : "a number", node, operand, problems);
        return applies ? TypeRules.promoted(operand, operand) : UnknownType.UNKNOWN;
    }

    private static void check(
            boolean applies,
            String wanted,
            Expression.Unary node,
            TypeSymbol operand,
            Problems problems) {
        if (!applies && !operand.isErroneous()) {
            problems.report(
                    Kind.OPERAND_TYPE,
                    node,
                    "'%s' needs %s, but %s has type %s"
                            .formatted(
                                    node.operator().symbol(),
                                    wanted,
                                    Problems.quoted(node.operand()),
                                    operand.text()));
        }
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
        return operator.divides()
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
