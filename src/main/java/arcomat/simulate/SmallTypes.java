package arcomat.simulate;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.LongStream;

/** Types of so few values that each can be tried. */
final class SmallTypes {
    private static final int FEW = 16;

    private SmallTypes() {}

    /** All values, or empty for a type that has more than a few. */
    static Optional<List<Value>> values(Type type) {
        if (type instanceof Type.BooleanType) {
            return Optional.of(
                    List.of(new Value.BooleanValue(false), new Value.BooleanValue(true)));
        }
        if (type instanceof Type.EnumType enumeration && enumeration.constants().size() <= FEW) {
            return Optional.of(
                    IntStream.range(0, enumeration.constants().size())
                            .<Value>mapToObj(i -> new Value.EnumValue(enumeration, i))
                            .toList());
        }
        if (type instanceof Type.IntegerType integer
                && integer.ranged()
                && integer.high() - integer.low() < FEW
                && integer.high() - integer.low() >= 0) {
            return Optional.of(
                    LongStream.rangeClosed(integer.low(), integer.high())
                            .<Value>mapToObj(Value.IntegerValue::new)
                            .toList());
        }
        return Optional.empty();
    }
}
