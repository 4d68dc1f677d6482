package arcomat.analysis.coupling;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.Optional;
import java.util.stream.Stream;

/**
 * Reads values of a type as they are written in conditions. Empty where a text is none: a number
 * that a type does not have is none of its numbers, however near it is to one.
 */
record ValueText(String text) implements Type.Cases<Optional<Value>> {
    Optional<Value> of(Type type) {
        return type.match(this);
    }

    static Optional<Long> whole(String text) {
        try {
            return Optional.of(Long.parseLong(text));
        } catch (NumberFormatException none) {
            return Optional.empty();
        }
    }

    @Override
    public Optional<Value> booleanType(Type.BooleanType type) {
        return Stream.of(true, false)
                .filter(truth -> text.equals(String.valueOf(truth)))
                .<Value>map(Value.BooleanValue::new)
                .findFirst();
    }

    @Override
    public Optional<Value> integerType(Type.IntegerType type) {
        return whole(text).map(Value.IntegerValue::new);
    }

    @Override
    public Optional<Value> realType(Type.RealType type) {
        try {
            Value number = new Value.RealValue(Double.parseDouble(text));
            return Optional.of(number).filter(type::has);
        } catch (NumberFormatException none) {
            return Optional.empty();
        }
    }

    @Override
    public Optional<Value> characterType(Type.CharacterType type) {
        return TextLiteral.read(text, '\'')
                .filter(each -> each.length() == 1)
                .map(each -> new Value.CharacterValue(each.charAt(0)));
    }

    @Override
    public Optional<Value> stringType(Type.StringType type) {
        return TextLiteral.read(text, '"').map(Value.StringValue::new);
    }

    @Override
    public Optional<Value> enumType(Type.EnumType type) {
        int ordinal = type.constants().indexOf(text);
        return ordinal < 0 ? Optional.empty() : Optional.of(new Value.EnumValue(type, ordinal));
    }

    @Override
    public Optional<Value> classType(Type.ClassType type) {
        return Optional.empty();
    }
}
