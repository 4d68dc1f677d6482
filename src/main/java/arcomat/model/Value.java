package arcomat.model;

import java.util.List;
import java.util.stream.Collectors;

/**
 * A message, or what a variable holds. {@code toString} is its text in models and traces. Values of
 * one type have an order: numbers by size, constants by declaration, all else by its text.
 */
public sealed interface Value extends Comparable<Value> {
    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Cases<R> cases);

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    interface Cases<R> {
        R booleanValue(BooleanValue booleanValue);

        R integerValue(IntegerValue integerValue);

        R realValue(RealValue realValue);

        R characterValue(CharacterValue characterValue);

        R stringValue(StringValue stringValue);

        R enumValue(EnumValue enumValue);

        R objectValue(ObjectValue objectValue);
    }

    @Override
    default int compareTo(Value other) {
        return toString().compareTo(other.toString());
    }

    /**
     * The number that an integer or a character is.
     *
     * @throws IllegalStateException for all else
     */
    default long whole() {
        throw new IllegalStateException("no whole number: " + this);
    }

    /** As in Java's literals, so that every text stays on one line and can be read again. */
    private static String escaped(String text, char quote) {
        StringBuilder escaped = new StringBuilder(text.length());
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            switch (c) {
                case '\n' -> escaped.append("\\n");
                case '\r' -> escaped.append("\\r");
                case '\t' -> escaped.append("\\t");
                case '\\' -> escaped.append("\\\\");
                default -> {
                    if (c == quote) {
                        escaped.append('\\').append(c);
                    } else if (Character.isISOControl(c) || isHalf(text, i)) {
                        escaped.append(String.format("\\u%04x", (int) c));
                    } else {
                        escaped.append(c);
                    }
                }
            }
        }
        return escaped.toString();
    }

    /** Whether a character is half of one, whose other half is missing: no file can hold it. */
    private static boolean isHalf(String text, int at) {
        return Character.isSurrogate(text.charAt(at)) && !isPair(text, at) && !isPair(text, at - 1);
    }

    private static boolean isPair(String text, int at) {
        return at >= 0
                && at + 1 < text.length()
                && Character.isSurrogatePair(text.charAt(at), text.charAt(at + 1));
    }

    record BooleanValue(boolean value) implements Value {
        @Override
        public String toString() {
            return String.valueOf(value);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.booleanValue(this);
        }
    }

    record IntegerValue(long value) implements Value {
        @Override
        public String toString() {
            return String.valueOf(value);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.integerValue(this);
        }

        @Override
        public long whole() {
            return value;
        }

        @Override
        public int compareTo(Value other) {
            return other instanceof IntegerValue number
                    ? Long.compare(value, number.value)
                    : Value.super.compareTo(other);
        }
    }

    record RealValue(double value) implements Value {
        @Override
        public String toString() {
            return String.valueOf(value);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.realValue(this);
        }

        @Override
        public int compareTo(Value other) {
            return other instanceof RealValue number
                    ? order(value, number.value)
                    : Value.super.compareTo(other);
        }

        /**
         * Two zeros are two values, and what is no number is one, as Java has it for records. Said
         * here, since a browser takes the zeros for one: then a component that sends the wrong one
         * keeps its promise.
         */
        @Override
        public boolean equals(Object other) {
            return other instanceof RealValue number && order(value, number.value) == 0;
        }

        @Override
        public int hashCode() {
            return Long.hashCode(Double.doubleToLongBits(value));
        }

        private static int order(double one, double other) {
            if (one < other) {
                return -1;
            }
            return one > other
                    ? 1
                    : Long.compare(Double.doubleToLongBits(one), Double.doubleToLongBits(other));
        }
    }

    record CharacterValue(char value) implements Value {
        @Override
        public String toString() {
            return "'" + escaped(String.valueOf(value), '\'') + "'";
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.characterValue(this);
        }

        @Override
        public long whole() {
            return value;
        }

        @Override
        public int compareTo(Value other) {
            return other instanceof CharacterValue character
                    ? Character.compare(value, character.value)
                    : Value.super.compareTo(other);
        }
    }

    record StringValue(String value) implements Value {
        @Override
        public String toString() {
            return "\"" + escaped(value, '"') + "\"";
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.stringValue(this);
        }
    }

    record EnumValue(Type.EnumType type, int ordinal) implements Value {
        @Override
        public String toString() {
            return type.constants().get(ordinal);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.enumValue(this);
        }

        @Override
        public int compareTo(Value other) {
            return other instanceof EnumValue constant
                    ? Integer.compare(ordinal, constant.ordinal)
                    : Value.super.compareTo(other);
        }
    }

    /** An object of a class diagram's class; attributes in the order of {@link Type.ClassType}. */
    record ObjectValue(Type.ClassType type, List<Value> attributes) implements Value {
        public ObjectValue {
            attributes = List.copyOf(attributes);
        }

        @Override
        public String toString() {
            return attributes.stream()
                    .map(Value::toString)
                    .collect(Collectors.joining(", ", simpleName() + "(", ")"));
        }

        private String simpleName() {
            return type.className().substring(type.className().lastIndexOf('.') + 1);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.objectValue(this);
        }
    }
}
