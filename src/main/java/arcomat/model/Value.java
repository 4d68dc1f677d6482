package arcomat.model;

import java.util.List;
import java.util.stream.Collectors;

/** A message, or what a variable holds. {@code toString} is its text in models and traces. */
public sealed interface Value {

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
            return "'" + value + "'";
        }
    }

    record StringValue(String value) implements Value {
        @Override
        public String toString() {
            return "\"" + value.replace("\\", "\\\\").replace("\"", "\\\"") + "\"";
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
