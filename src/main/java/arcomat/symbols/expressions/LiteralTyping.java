package arcomat.symbols.expressions;

import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.Literals;
import arcomat.tree.Expression;
import arcomat.tree.Expression.Literal;

import java.util.OptionalLong;

/** Types and values of literals. */
final class LiteralTyping {
    private LiteralTyping() {}

    /** A literal on its own. */
    static TypedExpression type(Literal literal, boolean negated, ProblemSink problems) {
        return switch (literal.kind()) {
            case BOOLEAN ->
                    new TypedExpression.Literal(
                            literal, Literals.isTrue(literal), BuiltinType.BOOLEAN);
            case INT -> whole(literal, BuiltinType.INTEGER, negated, problems);
            case LONG -> whole(literal, BuiltinType.LONG, negated, problems);
            case FLOAT -> real(literal, BuiltinType.FLOAT, problems);
            case DOUBLE -> real(literal, BuiltinType.DOUBLE, problems);
            case CHAR -> character(literal, problems);
            case STRING -> string(literal, problems);
            case NULL -> nothing(literal, problems);
        };
    }

    /** A literal behind a minus: one more than the greatest number is fine there. */
    static TypedExpression magnitude(Literal literal, ProblemSink problems) {
        return type(literal, true, problems);
    }

    private static TypedExpression whole(
            Literal literal, BuiltinType type, boolean negated, ProblemSink problems) {
        OptionalLong value = Literals.wholeNumber(literal, negated);
        if (value.isEmpty() || value.getAsLong() < type.low() || value.getAsLong() > type.high()) {
            String advice = type == BuiltinType.INTEGER ? "; append L for a Long" : "";
            return wrong(
                    literal,
                    "'" + literal.text() + "' is too large for " + type + advice,
                    problems);
        }
        long magnitude = negated ? -value.getAsLong() : value.getAsLong();
        return new TypedExpression.Literal(literal, magnitude, type);
    }

    private static TypedExpression real(Literal literal, BuiltinType type, ProblemSink problems) {
        double value = Literals.realNumber(literal);
        return Double.isInfinite(value)
                ? wrong(literal, "'" + literal.text() + "' is too large for " + type, problems)
                : new TypedExpression.Literal(literal, value, type);
    }

    private static TypedExpression character(Literal literal, ProblemSink problems) {
        return Literals.unquoted(literal)
                .filter(text -> text.length() == 1)
                .<TypedExpression>map(
                        text ->
                                new TypedExpression.Literal(
                                        literal, text.charAt(0), BuiltinType.CHARACTER))
                .orElseGet(
                        () -> wrong(literal, literal.text() + " is not one character", problems));
    }

    private static TypedExpression string(Literal literal, ProblemSink problems) {
        return Literals.unquoted(literal)
                .<TypedExpression>map(
                        text -> new TypedExpression.Literal(literal, text, BuiltinType.STRING))
                .orElseGet(
                        () ->
                                wrong(
                                        literal,
                                        literal.text() + " has an escape that Java does not know",
                                        problems));
    }

    private static TypedExpression nothing(Literal literal, ProblemSink problems) {
        problems.report(
                ExpressionProblem.Kind.UNSUPPORTED_EXPRESSION,
                literal,
                "there is no null in models; write -- for no message");
        return new TypedExpression.Erroneous(literal, java.util.List.of());
    }

    private static TypedExpression wrong(Expression literal, String message, ProblemSink problems) {
        problems.report(ExpressionProblem.Kind.LITERAL_OVERFLOW, literal, message);
        return new TypedExpression.Erroneous(literal, java.util.List.of());
    }
}
