package arcomat.pipeline.compile;

import arcomat.model.Type;
import arcomat.model.Value;

/**
 * What a field or a parameter of generated code holds for a value; each place says what an object
 * is to it.
 */
public interface FieldForm extends Value.Cases<Object> {
    /** The type of the field, as the model says it. */
    Type type();

    /** The object for a value of the type: enums are their codes, integers Java's int or long. */
    default Object of(Value value) {
        return value.match(this);
    }

    @Override
    default Object booleanValue(Value.BooleanValue truth) {
        return truth.value();
    }

    @Override
    default Object integerValue(Value.IntegerValue integer) {
        boolean isLong =
                type() instanceof Type.IntegerType whole && whole.width() == Type.Width.LONG;
        return isLong ? (Object) integer.value() : (Object) (int) integer.value();
    }

    @Override
    default Object realValue(Value.RealValue real) {
        boolean isSingle = type() instanceof Type.RealType number && number.single();
        return isSingle ? (Object) (float) real.value() : (Object) real.value();
    }

    @Override
    default Object characterValue(Value.CharacterValue character) {
        return character.value();
    }

    @Override
    default Object stringValue(Value.StringValue string) {
        return string.value();
    }

    /** Generated enums count from one: zero is silence. */
    @Override
    default Object enumValue(Value.EnumValue constant) {
        return constant.ordinal() + 1;
    }
}
