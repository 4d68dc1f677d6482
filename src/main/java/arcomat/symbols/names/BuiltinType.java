package arcomat.symbols.names;

import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** The built-in types; a Java primitive and its box are one type. */
public enum BuiltinType implements TypeSymbol {
    BOOLEAN("Boolean", "boolean"),
    BYTE("byte", "Byte", Byte.MIN_VALUE, Byte.MAX_VALUE),
    SHORT("short", "Short", Short.MIN_VALUE, Short.MAX_VALUE),
    CHARACTER("char", "Character", Character.MIN_VALUE, Character.MAX_VALUE),
    INTEGER("Integer", "int", Integer.MIN_VALUE, Integer.MAX_VALUE),
    LONG("Long", "long", Long.MIN_VALUE, Long.MAX_VALUE),
    FLOAT("float", "Float"),
    DOUBLE("Double", "double"),
    STRING("String", "java.lang.String");

    private static final Map<String, BuiltinType> BY_NAME = byName();

    /** What other languages call them, in small letters. */
    private static final Map<String, BuiltinType> FOREIGN =
            Map.ofEntries(
                    Map.entry("int8", BYTE),
                    Map.entry("int16", SHORT),
                    Map.entry("int32", INTEGER),
                    Map.entry("int64", LONG),
                    Map.entry("i8", BYTE),
                    Map.entry("i16", SHORT),
                    Map.entry("i32", INTEGER),
                    Map.entry("i64", LONG),
                    Map.entry("float32", FLOAT),
                    Map.entry("float64", DOUBLE),
                    Map.entry("f32", FLOAT),
                    Map.entry("f64", DOUBLE),
                    Map.entry("real", DOUBLE),
                    Map.entry("text", STRING));

    /** So many letters of a name tell it from the others. */
    private static final int SHORTEST_BEGINNING = 3;

    private final String displayName;
    private final String otherName;
    private final long low;
    private final long high;

    BuiltinType(String displayName, String otherName) {
        this(displayName, otherName, 0, 0);
    }

    BuiltinType(String displayName, String otherName, long low, long high) {
        this.displayName = displayName;
        this.otherName = otherName;
        this.low = low;
        this.high = high;
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

    /**
     * The type that another language has under a name, or that the name is the beginning of: {@code
     * bool} and {@code Int}, {@code int64}, {@code str}.
     */
    public static Optional<BuiltinType> meantBy(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        BuiltinType foreign = FOREIGN.get(lower);
        if (foreign != null || lower.length() < SHORTEST_BEGINNING) {
            return Optional.ofNullable(foreign);
        }
        List<BuiltinType> begun =
                Stream.of(values()).filter(each -> each.beginsWith(lower)).toList();
        return begun.size() == 1 ? Optional.of(begun.get(0)) : Optional.empty();
    }

    private boolean beginsWith(String lower) {
        return displayName.toLowerCase(Locale.ROOT).startsWith(lower)
                || otherName.toLowerCase(Locale.ROOT).startsWith(lower);
    }

    /** Whether a name as written is one of Java's for what is no object. */
    static boolean isPrimitive(String name) {
        return BY_NAME.containsKey(name)
                && Character.isLowerCase(name.charAt(0))
                && !name.contains(".");
    }

    @Override
    public String text() {
        return displayName;
    }

    /** Java's simple name for it where an object is needed. */
    public String objectName() {
        return Character.isUpperCase(displayName.charAt(0)) ? displayName : otherName;
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
        return ofWhole(low);
    }

    /** The greatest whole number of this type. */
    public long high() {
        return ofWhole(high);
    }

    private long ofWhole(long end) {
        if (!isWhole()) {
            throw new IllegalStateException(displayName);
        }
        return end;
    }
}
