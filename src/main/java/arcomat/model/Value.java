package arcomat.model;

import java.util.List;
import java.util.stream.Collectors;

/** A message, or what a variable holds. {@code toString} is its text in models and traces. */
public sealed interface Value {

    /** As in Java's literals, so that every text stays on one line and can be read again. */
    private static String escaped(String text, char quote) {
        StringBuilder escaped = new StringBuilder(text.length());
        for (char c : text.toCharArray()) {
            switch (c) {
                case '\n' -> escaped.append("\\n");
                case '\r' -> escaped.append("\\r");
                case '\t' -> escaped.append("\\t");
                case '\\' -> escaped.append("\\\\");
                default -> {
                    if (c == quote) {
                        escaped.append('\\').append(c);
                    } else if (Character.isISOControl(c)) {
                        escaped.append(String.format("\\u%04x", (int) c));
                    } else {
                        escaped.append(c);
                    }
                }
            }
        }
        return escaped.toString();
    }

    record BooleanValue(boolean value) implements Value {
        @Override
        public String toString() {
            return String.valueOf(value);
        }
    }

    record IntegerValue(long value) implements Value {
        @Override
        public String toString() {
            return String.valueOf(value);
        }
    }

    record RealValue(double value) implements Value {
        @Override
        public String toString() {
            return String.valueOf(value);
        }
    }

    record CharacterValue(char value) implements Value {
        @Override
        public String toString() {
            return "'" + escaped(String.valueOf(value), '\'') + "'";
        }
    }

    record StringValue(String value) implements Value {
        @Override
        public String toString() {
            return "\"" + escaped(value, '"') + "\"";
        }
    }

    record EnumValue(Type.EnumType type, int ordinal) implements Value {
        @Override
        public String toString() {
            return type.constants().get(ordinal);
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
                    .collect(Collectors.joining(", ", type.simpleName() + "(", ")"));
        }
    }
}
