package arcomat.model;

/**
 * The first value of a type: 0, false, the empty string, the first constant of an enumeration, the
 * low end of a range without 0. Variables start with it, and where a model leaves open which
 * message a total port carries, a run without random choices sends it.
 */
public final class FirstValue {
    private FirstValue() {}

    public static Value of(Type type) {
        if (type instanceof Type.BooleanType) {
            return new Value.BooleanValue(false);
        }
        if (type instanceof Type.IntegerType integer) {
            boolean zero = integer.low() <= 0 && 0 <= integer.high();
            return new Value.IntegerValue(zero ? 0 : integer.low());
        }
        if (type instanceof Type.RealType) {
            return new Value.RealValue(0);
        }
        if (type instanceof Type.CharacterType) {
            return new Value.CharacterValue((char) 0);
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
