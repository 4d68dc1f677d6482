package arcomat.pipeline.check;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.Optional;

/** Reads values as they are written on the command line; the type tells how. */
final class WrittenValue {
    private WrittenValue() {}

    /** The value, or empty where the text is none of the type. */
    static Optional<Value> parse(String text, Type type) {
        try {
            return parseNumber(text, type).or(() -> parseOther(text, type));
        } catch (NumberFormatException e) {
            return Optional.empty();
        }
    }

    private static Optional<Value> parseNumber(String text, Type type) {
        if (type instanceof Type.IntegerType integer) {
            long number = Long.decode(text);
            boolean fits = number >= integer.low() && number <= integer.high();
            return fits ? Optional.of(new Value.IntegerValue(number)) : Optional.empty();
        }
        if (type instanceof Type.RealType real) {
            double number = Double.parseDouble(text);
            return Optional.of(new Value.RealValue(real.single() ? (float) number : number));
        }
        return Optional.empty();
    }

    private static Optional<Value> parseOther(String text, Type type) {
        if (type instanceof Type.BooleanType && text.matches("true|false")) {
            return Optional.of(new Value.BooleanValue(Boolean.parseBoolean(text)));
        }
        if (type instanceof Type.StringType && text.matches("(?s)\".*\"") && text.length() > 1) {
            return Optional.of(new Value.StringValue(text.substring(1, text.length() - 1)));
        }
        if (type instanceof Type.CharacterType && text.matches("(?s)'.'")) {
            return Optional.of(new Value.CharacterValue(text.charAt(1)));
        }
        if (type instanceof Type.EnumType enumeration) {
            String constant = text.substring(text.lastIndexOf('.') + 1);
            int ordinal = enumeration.constants().indexOf(constant);
            return ordinal < 0
                    ? Optional.empty()
                    : Optional.of(new Value.EnumValue(enumeration, ordinal));
        }
        return Optional.empty();
    }
}
