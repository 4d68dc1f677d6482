package arcomat.symbols.names;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** The built-in types; a Java primitive and its box are one type. */
public enum BuiltinType implements TypeSymbol {
    BOOLEAN("Boolean", "boolean"),
    BYTE("byte", "Byte"),
    SHORT("short", "Short"),
    CHARACTER("char", "Character"),
    INTEGER("Integer", "int"),
    LONG("Long", "long"),
    FLOAT("float", "Float"),
    DOUBLE("Double", "double"),
    STRING("String", "java.lang.String");

    private static final Map<String, BuiltinType> BY_NAME = byName();

    private final String displayName;
    private final String otherName;

    BuiltinType(String displayName, String otherName) {
        this.displayName = displayName;
        this.otherName = otherName;
    }

    private static Map<String, BuiltinType> byName() {
        Map<String, BuiltinType> map = new HashMap<>();
        for (BuiltinType type : values()) {
            map.put(type.displayName, type);
            map.put(type.otherName, type);
        }
        return Map.copyOf(map);
    }

    /** The built-in type that a name as written stands for. */
    public static Optional<BuiltinType> named(String name) {
        return Optional.ofNullable(BY_NAME.get(name));
    }

    @Override
    public String text() {
        return displayName;
    }

    @Override
    public String toString() {
        return displayName;
    }

    /** Whether it is a number type in the sense of Java, {@code char} included. */
    public boolean isNumber() {
        return this != BOOLEAN && this != STRING;
    }

    public boolean isWhole() {
        return isNumber() && !isReal();
    }

    public boolean isReal() {
        return this == FLOAT || this == DOUBLE;
    }

    /** The smallest whole number of this type. */
    public long low() {
        return switch (this) {
            case BYTE -> Byte.MIN_VALUE;
            case SHORT -> Short.MIN_VALUE;
            case CHARACTER -> Character.MIN_VALUE;
            case INTEGER -> Integer.MIN_VALUE;
            case LONG -> Long.MIN_VALUE;
            case BOOLEAN, FLOAT, DOUBLE, STRING -> throw new IllegalStateException(displayName);
        };
    }

    /** The greatest whole number of this type. */
    public long high() {
        return switch (this) {
            case BYTE -> Byte.MAX_VALUE;
            case SHORT -> Short.MAX_VALUE;
            case CHARACTER -> Character.MAX_VALUE;
            case INTEGER -> Integer.MAX_VALUE;
            case LONG -> Long.MAX_VALUE;
            case BOOLEAN, FLOAT, DOUBLE, STRING -> throw new IllegalStateException(displayName);
        };
    }
}
