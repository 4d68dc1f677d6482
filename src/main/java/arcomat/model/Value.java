package arcomat.model;

import java.util.List;
import java.util.stream.Collectors;

/** A message, or what a variable holds. {@code toString} is its text in models and traces. */
public sealed interface Value {
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

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.objectValue(this);
        }
    }
}
