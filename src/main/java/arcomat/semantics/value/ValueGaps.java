package arcomat.semantics.value;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Samples of a type beside some of its values.
 *
 * @param values of the type, in their natural order
 */
public record ValueGaps(Type type, List<Value> values) {

    /** One value that is none of them, the simplest; none where they are all. */
    public List<Value> any() {
        Value first = type.first();
        if (!values.contains(first)) {
            return List.of(first);
        }
        Set<Value> taken = new HashSet<>(values);
        return FirstValues.of(type, values.size() + 1).stream()
                .filter(value -> !taken.contains(value))
                .limit(1)
                .toList();
    }

    /** One value of each gap: before the first, between two, behind the last. */
    public List<Value> gaps() {
        if (values.isEmpty()) {
            return List.of(type.first());
        }
        if (!type.isNumber()) {
            return any();
        }
        if (type instanceof Type.RealType real) {
            return new RealGaps(real, values).samples();
        }
        return type instanceof Type.IntegerType integer
                ? wholeGaps(integer.low(), integer.high())
                : wholeGaps(Character.MIN_VALUE, Character.MAX_VALUE);
    }

    private List<Value> wholeGaps(long low, long high) {
        List<Value> gaps = new ArrayList<>();
        long first = values.get(0).whole();
        if (low < first) {
            gaps.add(value(first - 1));
        }
        long last = first;
        for (Value value : values.subList(1, values.size())) {
            long next = value.whole();
            if (last < next - 1) {
                gaps.add(value(next - 1));
            }
            last = next;
        }
        if (last < high) {
            gaps.add(value(last + 1));
        }
        return gaps;
    }

    private Value value(long number) {
        return type instanceof Type.CharacterType
                ? new Value.CharacterValue((char) number)
                : new Value.IntegerValue(number);
    }
}
