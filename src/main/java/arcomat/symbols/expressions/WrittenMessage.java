package arcomat.symbols.expressions;

import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.RangeType;
import arcomat.symbols.names.TypeSymbol;

import java.util.Optional;
import java.util.OptionalInt;

/** Reads a message where text stands for it, as in a stereotype; the type tells how. */
public final class WrittenMessage {
    private WrittenMessage() {}

    /**
     * A Boolean, a Long for a whole number, a Double, a Character or a String; for a constant of an
     * enumeration its position as an Integer. Empty where the text is no message of the type.
     */
    public static Optional<Object> read(String text, TypeSymbol type) {
        if (type instanceof EnumSymbol enumeration) {
            OptionalInt ordinal = enumeration.ordinal(text);
            return ordinal.isPresent() ? Optional.of(ordinal.getAsInt()) : Optional.empty();
        }
        return type.base() instanceof BuiltinType base ? read(text, base, type) : Optional.empty();
    }

    private static Optional<Object> read(String text, BuiltinType base, TypeSymbol type) {
        return switch (base) {
            case BOOLEAN ->
                    text.equals("true") || text.equals("false")
                            ? Optional.of(text.equals("true"))
                            : Optional.empty();
            case BYTE, SHORT, INTEGER, LONG ->
                    type instanceof RangeType range
                            ? whole(text, range.low(), range.high())
                            : whole(text, base.low(), base.high());
            case CHARACTER -> text.length() == 1 ? Optional.of(text.charAt(0)) : Optional.empty();
            case FLOAT, DOUBLE ->
                    text.matches("-?[0-9]+(\\.[0-9]+)?")
                            ? Optional.of(Double.parseDouble(text))
                            : Optional.empty();
            case STRING -> Optional.of(text);
        };
    }

    private static Optional<Object> whole(String text, long low, long high) {
        if (!text.matches("-?[0-9]{1,19}")) {
            return Optional.empty();
        }
        try {
            long number = Long.parseLong(text);
            return low <= number && number <= high ? Optional.of(number) : Optional.empty();
        } catch (NumberFormatException tooLarge) {
            return Optional.empty();
        }
    }
}
