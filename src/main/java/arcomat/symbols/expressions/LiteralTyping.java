package arcomat.symbols.expressions;

import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.LiteralValues;
import arcomat.tree.Expression.Literal;

import java.util.OptionalLong;

/** Types and values of literals. */
final class LiteralTyping {
    private LiteralTyping() {}

    /**
     * @param negated whether it stands behind a minus
     */
    static TypedExpression type(Literal literal, boolean negated, Problems problems) {
        return switch (literal.kind()) {
            case BOOLEAN ->
                    new TypedExpression.Literal(
                            literal, LiteralValues.isTrue(literal), BuiltinType.BOOLEAN);
            case INT -> whole(literal, BuiltinType.INTEGER, negated, problems);
            case LONG -> whole(literal, BuiltinType.LONG, negated, problems);
            case FLOAT -> real(literal, BuiltinType.FLOAT, problems);
            case DOUBLE -> real(literal, BuiltinType.DOUBLE, problems);
            case CHAR -> character(literal, problems);
            case STRING -> string(literal, problems);
            case NULL ->
                    problems.erroneous(
                            Kind.UNSUPPORTED_EXPRESSION,
                            literal,
                            "null is no value to calculate with; a port is compared with it by =="
                                    + " or !=");
        };
    }

    private static TypedExpression whole(
            Literal literal, BuiltinType type, boolean negated, Problems problems) {
        OptionalLong value = LiteralValues.wholeNumber(literal, negated);
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

    private static TypedExpression real(Literal literal, BuiltinType type, Problems problems) {
        double value = LiteralValues.realNumber(literal);
        if (Double.isInfinite(value)) {
            return wrong(literal, "'" + literal.text() + "' is too large for " + type, problems);
        }
        return LiteralValues.isLost(literal.text(), value)
                ? wrong(literal, lost(literal, type), problems)
                : new TypedExpression.Literal(literal, value, type);
    }

    private static String lost(Literal literal, BuiltinType type) {
        return "'%s' is too small for %s and would be 0; write 0 or a larger number"
                .formatted(literal.text(), type);
    }

    private static TypedExpression character(Literal literal, Problems problems) {
        return LiteralValues.unquoted(literal)
                .filter(text -> text.length() == 1)
                .<TypedExpression>map(
                        text ->
                                new TypedExpression.Literal(
                                        literal, text.charAt(0), BuiltinType.CHARACTER))
                .orElseGet(() -> wrong(literal, literal.text() + noCharacter(literal), problems));
    }

    private static String noCharacter(Literal literal) {
        boolean pair =
                LiteralValues.unquoted(literal)
                        .filter(text -> text.codePoints().count() == 1)
                        .isPresent();
        return pair
                ? " takes two of Java's characters and fits no char; write it in a String"
                : " is not one character";
    }

    private static TypedExpression string(Literal literal, Problems problems) {
        return LiteralValues.unquoted(literal)
                .<TypedExpression>map(
                        text -> new TypedExpression.Literal(literal, text, BuiltinType.STRING))
                .orElseGet(
                        () ->
                                wrong(
                                        literal,
                                        literal.text() + " has an escape that Java does not know",
                                        problems));
    }

    private static TypedExpression wrong(Literal literal, String message, Problems problems) {
        return problems.erroneous(Kind.LITERAL_OVERFLOW, literal, message);
    }
}
