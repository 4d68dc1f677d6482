package arcomat.analysis;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/** All values of a small type, those at the limits of a large one; without the engine. */
public final class SomeValues {
    private SomeValues() {}

    public static List<Value> of(Type type) {
        if (type instanceof Type.BooleanType) {
            return List.of(new Value.BooleanValue(false), new Value.BooleanValue(true));
        }
        if (type instanceof Type.EnumType enumeration) {
            return IntStream.range(0, enumeration.constants().size())
                    .<Value>mapToObj(i -> new Value.EnumValue(enumeration, i))
                    .toList();
        }
        if (type instanceof Type.IntegerType integer) {
            return integers(integer).<Value>mapToObj(Value.IntegerValue::new).toList();
        }
        if (type instanceof Type.RealType real) {
            double most = real.single() ? Float.MAX_VALUE : Double.MAX_VALUE;
            return DoubleStream.of(-most, -1, 0, 1, most)
                    .<Value>mapToObj(Value.RealValue::new)
                    .toList();
        }
        if (type instanceof Type.CharacterType) {
            return "\0-0Aaz\uffff"
                    .chars()
                    .<Value>mapToObj(code -> new Value.CharacterValue((char) code))
                    .toList();
        }
        return type instanceof Type.ClassType object ? objects(object) : List.of();
    }

    private static LongStream integers(Type.IntegerType type) {
        boolean small = type.high() - type.low() >= 0 && type.high() - type.low() < 1000;
        return small
                ? LongStream.rangeClosed(type.low(), type.high())
                : LongStream.of(type.low(), type.low() + 1, 0, type.high() - 1, type.high());
    }

    private static List<Value> objects(Type.ClassType type) {
        List<List<Value>> rows = List.of(List.of());
        for (Type.Attribute attribute : type.attributes()) {
            List<List<Value>> longer = new ArrayList<>();
            for (List<Value> row : rows) {
                for (Value value : of(attribute.type())) {
                    longer.add(Stream.concat(row.stream(), Stream.of(value)).toList());
                }
            }
            rows = longer;
        }
        return rows.stream().<Value>map(row -> new Value.ObjectValue(type, row)).toList();
    }
}
