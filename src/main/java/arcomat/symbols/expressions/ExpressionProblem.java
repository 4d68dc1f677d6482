package arcomat.symbols.expressions;

import arcomat.source.Span;

import java.util.Optional;

/**
 * Something wrong inside an expression; the checks give each kind its code.
 *
 * @param message what is wrong and what to do, for the finding
 * @param suggestion the name that was probably meant, to stand in place of the span
 */
public record ExpressionProblem(Kind kind, Span span, String message, Optional<String> suggestion) {
    public enum Kind {
        /** No port, variable, parameter, type or constant has that name. */
        UNKNOWN_NAME,
        /** The name of a type could mean several. */
        AMBIGUOUS_NAME,
        /** The enumeration has no such constant. */
        UNKNOWN_CONSTANT,
        /** The class has no such attribute, or the value has no attributes at all. */
        UNKNOWN_ATTRIBUTE,
        /** The operator does not take operands of these types. */
        OPERAND_TYPE,
        /** The cast converts between types that do not convert. */
        CAST,
        /** A method call or the construction of an object. */
        UNSUPPORTED_CALL,
        /** Another expression of Java that models do not have. */
        UNSUPPORTED_EXPRESSION,
        /** A literal beyond its type, or one that cannot be read. */
        LITERAL_OVERFLOW,
        /** Division by the literal zero. */
        DIVISION_BY_ZERO,
        /** {@code == --} asked of something that is no port. */
        ABSENCE_OF_NO_PORT,
        /** A name that a quantifier or a {@code let} gives is taken, or not used. */
        BOUND_NAME,
        /** What a quantifier is about is no finite set, or a large one. */
        DOMAIN
    }
}
