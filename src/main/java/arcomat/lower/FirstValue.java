package arcomat.lower;

import arcomat.model.Type;
import arcomat.model.Value;

/** What a variable holds where the model gives it no initial value. */
final class FirstValue {
    private FirstValue() {}

    static Value of(Type type) {
        if (type instanceof Type.BooleanType) {
            return new Value.BooleanValue(false);
        }
        if (type instanceof Type.IntegerType range) {
            boolean hasZero = range.low() <= 0 && 0 <= range.high();
            return new Value.IntegerValue(hasZero ? 0 : range.low());
        }
        if (type instanceof Type.RealType) {
            return new Value.RealValue(0);
        }
        if (type instanceof Type.CharacterType) {
            return new Value.CharacterValue('\0');
        }
        if (type instanceof Type.StringType) {
            return new Value.StringValue("");
        }
        if (type instanceof Type.EnumType enumeration) {
            return new Value.EnumValue(enumeration, 0);
        }
        if (type instanceof Type.ClassType object) {
            return new Value.ObjectValue(
                    object, object.attributes().stream().map(a -> of(a.type())).toList());
        }
        throw new AssertionError(type);
    }
}
