package arcomat.lower;

import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.symbols.expressions.WrittenMessage;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Name;

import java.util.Optional;

/** Messages that text stands for, as values of the model. */
final class WrittenMessages {
    private WrittenMessages() {}

    /** Empty where the text is no message of the type, which has a finding. */
    static Optional<Value> lower(Name written, TypeSymbol symbol, Type type) {
        return WrittenMessage.read(written.text(), symbol).map(message -> value(message, type));
    }

    private static Value value(Object message, Type type) {
        if (type instanceof Type.EnumType enumeration) {
            return new Value.EnumValue(enumeration, (Integer) message);
        }
        boolean single = type instanceof Type.RealType real && real.single();
        return single ? Conversion.convert(value(message), type) : value(message);
    }

    /** A Boolean, Long, Double, Character or String as a value. */
    static Value value(Object message) {
        if (message instanceof Boolean truth) {
            return new Value.BooleanValue(truth);
        }
        if (message instanceof Long number) {
            return new Value.IntegerValue(number);
        }
        if (message instanceof Double number) {
            return new Value.RealValue(number);
        }
        return message instanceof Character character
                ? new Value.CharacterValue(character)
                : new Value.StringValue((String) message);
    }
}
