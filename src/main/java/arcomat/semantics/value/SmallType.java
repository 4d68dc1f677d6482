package arcomat.semantics.value;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.LongStream;

/** Types of so few values that each can be tried. */
public final class SmallType implements Type.Cases<Optional<List<Value>>> {
    public static final int MOST = 4096;

    private static final Type.Cases<Optional<List<Value>>> FORMS = new SmallType();

    private SmallType() {}

    /** All values in their natural order; empty for a type that has too many. */
    public static Optional<List<Value>> values(Type type) {
        return type.match(FORMS);
    }

    @Override
    public Optional<List<Value>> booleanType(Type.BooleanType booleanType) {
        return Optional.of(List.of(new Value.BooleanValue(false), new Value.BooleanValue(true)));
    }

    @Override
    public Optional<List<Value>> integerType(Type.IntegerType integerType) {
        long last = integerType.high() - integerType.low();
        return last < 0 || last >= MOST // below 0 where it does not fit
                ? Optional.empty()
                : Optional.of(
                        LongStream.rangeClosed(integerType.low(), integerType.high())
                                .<Value>mapToObj(Value.IntegerValue::new)
                                .toList());
    }

    @Override
    public Optional<List<Value>> enumType(Type.EnumType enumType) {
        return Optional.of(
                IntStream.range(0, enumType.constants().size())
                        .<Value>mapToObj(i -> new Value.EnumValue(enumType, i))
                        .toList());
    }

    @Override
    public Optional<List<Value>> realType(Type.RealType realType) {
        return Optional.empty();
    }

    @Override
    public Optional<List<Value>> characterType(Type.CharacterType characterType) {
        return Optional.empty();
    }

    @Override
    public Optional<List<Value>> stringType(Type.StringType stringType) {
        return Optional.empty();
    }

    @Override
    public Optional<List<Value>> classType(Type.ClassType classType) {
        return Optional.empty();
    }
}
