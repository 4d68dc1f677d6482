package arcomat.semantics.value;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * The simplest values of a type: its first value, and then those near to it.
 *
 * @param count how many
 */
public record FirstValues(int count) implements Type.Cases<List<Value>> {

    /** As many different values; fewer where the type has no more. */
    public static List<Value> of(Type type, int count) {
        return type.match(new FirstValues(count));
    }

    @Override
    public List<Value> booleanType(Type.BooleanType booleanType) {
        return small(booleanType);
    }

    @Override
    public List<Value> integerType(Type.IntegerType integerType) {
        return numbers(integerType).limit(count).<Value>mapToObj(Value.IntegerValue::new).toList();
    }

    @Override
    public List<Value> realType(Type.RealType realType) {
        return upTo(count).<Value>mapToObj(Value.RealValue::new).toList();
    }

    @Override
    public List<Value> characterType(Type.CharacterType characterType) {
        return upTo(Math.min(count, Character.MAX_VALUE + 1))
                .<Value>mapToObj(code -> new Value.CharacterValue((char) code))
                .toList();
    }

    @Override
    public List<Value> stringType(Type.StringType stringType) {
        return upTo(count).<Value>mapToObj(n -> new Value.StringValue("a".repeat(n))).toList();
    }

    @Override
    public List<Value> enumType(Type.EnumType enumType) {
        return small(enumType);
    }

    private List<Value> small(Type type) {
        return SmallType.values(type).orElseThrow().stream().limit(count).toList();
    }

    private static IntStream upTo(int count) {
        return IntStream.range(0, count);
    }

    /** Upwards first, then what lies below. */
    private static LongStream numbers(Type.IntegerType type) {
        long first = ((Value.IntegerValue) type.first()).value();
        LongStream upwards = LongStream.rangeClosed(first, type.high());
        return first == type.low()
                ? upwards
                : LongStream.concat(
                        upwards, LongStream.iterate(first - 1, n -> n >= type.low(), n -> n - 1));
    }

    @Override
    public List<Value> classType(Type.ClassType type) {
        List<List<Value>> rows = List.of(List.of());
        for (Type.Attribute attribute : type.attributes()) {
            List<List<Value>> longer = new ArrayList<>();
            for (Value value : of(attribute.type(), count)) {
                for (List<Value> row : rows) {
                    longer.add(Stream.concat(row.stream(), Stream.of(value)).toList());
                }
            }
            rows = longer.subList(0, Math.min(count, longer.size()));
        }
        return rows.stream().<Value>map(row -> new Value.ObjectValue(type, row)).toList();
    }
}
