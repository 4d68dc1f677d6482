package arcomat.semantics.value;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.LongStream;

/** Types of so few values that each can be tried. */
public final class SmallType {
    public static final int MOST = 4096;

    private SmallType() {}

    /** All values in their natural order; empty for a type that has too many. */
    public static Optional<List<Value>> values(Type type) {
        if (type instanceof Type.BooleanType) {
            return Optional.of(
                    List.of(new Value.BooleanValue(false), new Value.BooleanValue(true)));
        }
        if (type instanceof Type.EnumType enumeration) {
            return Optional.of(
                    IntStream.range(0, enumeration.constants().size())
                            .<Value>mapToObj(i -> new Value.EnumValue(enumeration, i))
                            .toList());
        }
        if (type instanceof Type.IntegerType integer
                && integer.high() - integer.low() >= 0
                && integer.high() - integer.low() < MOST) {
            return Optional.of(
                    LongStream.rangeClosed(integer.low(), integer.high())
                            .<Value>mapToObj(Value.IntegerValue::new)
                            .toList());
        }
        return Optional.empty();
    }
}
