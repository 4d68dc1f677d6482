package arcomat.symbols.names;

/**
 * The type of a port, a variable, a parameter or an expression. Types are equal when they are the
 * same type: {@code Integer} and {@code int} are one.
 */
public sealed interface TypeSymbol
        permits BuiltinType,
                RangeType,
                DefinedType,
                JavaType,
                TypeVariable,
                UnsupportedType,
                UnknownType {

    /** The name for messages: simple for enums and classes. */
    String text();

    /** The type without its range. */
    default TypeSymbol base() {
        return this;
    }

    default boolean isBoolean() {
        return this == BuiltinType.BOOLEAN;
    }

    /** Whether arithmetic works on it. Java counts {@code char} in. */
    default boolean isNumeric() {
        return base() instanceof BuiltinType builtin && builtin.isNumber();
    }

    /** Whether it is one of Java's whole number types, {@code char} included. */
    default boolean isIntegral() {
        return base() instanceof BuiltinType builtin && builtin.isWhole();
    }

    /** Whether its messages are objects, which stream tests write as {@code Cup(5)}. */
    default boolean isObject() {
        return false;
    }

    /** Whether a finding about it has been or will be reported: nothing more should be said. */
    default boolean isErroneous() {
        return this instanceof UnknownType || this instanceof UnsupportedType;
    }
}
