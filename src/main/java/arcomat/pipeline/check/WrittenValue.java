package arcomat.pipeline.check;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.Optional;

/** Reads values as they are written on the command line; the type tells how. */
public final class WrittenValue implements Type.Cases<Optional<Value>> {
    private final String text;

    private WrittenValue(String text) {
        this.text = text;
    }

    /** The value, or empty where the text is none of the type. */
    public static Optional<Value> parse(String text, Type type) {
        try {
            return type.match(new WrittenValue(text));
        } catch (NumberFormatException e) {
            return Optional.empty();
        }
    }

    @Override
    public Optional<Value> booleanType(Type.BooleanType type) {
        return text.matches("true|false")
                ? Optional.of(new Value.BooleanValue(Boolean.parseBoolean(text)))
                : Optional.empty();
    }

    @Override
    public Optional<Value> integerType(Type.IntegerType type) {
        long number = Long.decode(text);
        boolean fits = number >= type.low() && number <= type.high();
        return fits ? Optional.of(new Value.IntegerValue(number)) : Optional.empty();
    }

    @Override
    public Optional<Value> realType(Type.RealType type) {
        double number = Double.parseDouble(text);
        return Optional.of(new Value.RealValue(type.rounded(number)));
    }

    @Override
    public Optional<Value> characterType(Type.CharacterType type) {
        return text.matches("(?s)'.'")
                ? Optional.of(new Value.CharacterValue(text.charAt(1)))
                : Optional.empty();
    }

    @Override
    public Optional<Value> stringType(Type.StringType type) {
        return text.matches("(?s)\".*\"") && text.length() > 1
                ? Optional.of(new Value.StringValue(text.substring(1, text.length() - 1)))
                : Optional.empty();
    }

    @Override
    public Optional<Value> enumType(Type.EnumType type) {
        int ordinal = type.constants().indexOf(text.substring(text.lastIndexOf('.') + 1));
        return ordinal < 0 ? Optional.empty() : Optional.of(new Value.EnumValue(type, ordinal));
    }

    /** Objects cannot be written. */
    @Override
    public Optional<Value> classType(Type.ClassType type) {
        return Optional.empty();
    }
}
