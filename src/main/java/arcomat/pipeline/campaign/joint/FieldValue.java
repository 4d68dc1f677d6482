package arcomat.pipeline.campaign.joint;

import arcomat.model.Type;
import arcomat.model.Value;

/** A value of a model as the fields and constructors of generated monitors take it. */
public record FieldValue(Type type) implements Value.Cases<Object> {
    /** The object for a value of the type; enums are their codes. */
    public Object of(Value value) {
        return value.match(this);
    }

    @Override
    public Object booleanValue(Value.BooleanValue truth) {
        return truth.value();
    }

    @Override
    public Object integerValue(Value.IntegerValue integer) {
        boolean isLong = type instanceof Type.IntegerType whole && whole.width() == Type.Width.LONG;
        return isLong ? (Object) integer.value() : (Object) (int) integer.value();
    }

    @Override
    public Object realValue(Value.RealValue real) {
        boolean isSingle = type instanceof Type.RealType number && number.single();
        return isSingle ? (Object) (float) real.value() : (Object) real.value();
    }

    @Override
    public Object characterValue(Value.CharacterValue character) {
        return character.value();
    }

    @Override
    public Object stringValue(Value.StringValue string) {
        return string.value();
    }

    @Override
    public Object enumValue(Value.EnumValue constant) {
        return constant.ordinal() + 1;
    }

    /** Neither what is read in a world nor what is written as an argument is one. */
    @Override
    public Object objectValue(Value.ObjectValue value) {
        throw new IllegalArgumentException("an object: " + value);
    }

    /** The object that a constructor takes, from its text. */
    static Object read(String text, Class<?> parameter) {
        return switch (parameter.getName()) {
            case "boolean" -> Boolean.valueOf(text);
            case "byte" -> Byte.valueOf(text);
            case "short" -> Short.valueOf(text);
            case "int" -> Integer.valueOf(text);
            case "long" -> Long.valueOf(text);
            case "float" -> Float.valueOf(text);
            case "double" -> Double.valueOf(text);
            case "char" -> text.charAt(0);
            default -> text;
        };
    }
}
