package arcomat.analysis.engine;

import arcomat.model.FirstValue;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Samples of a type beside some of its values.
 *
 * @param values in their natural order
 */
record Beside(Type type, List<Value> values) {

    /** One value that is none of them; none where they are all. */
    List<Value> any() {
        Value first = FirstValue.of(type);
        if (!values.contains(first)) {
            return List.of(first);
        }
        Optional<List<Value>> all = SmallType.values(type);
        if (all.isPresent()) {
            return all.get().stream().filter(value -> !values.contains(value)).limit(1).toList();
        }
        if (type instanceof Type.StringType) {
            return List.of(new Value.StringValue(freshText()));
        }
        List<Value> gaps = gaps();
        return gaps.isEmpty() ? List.of() : gaps.subList(gaps.size() - 1, gaps.size());
    }

    private String freshText() {
        String text = "a";
        while (values.contains(new Value.StringValue(text))) {
            text += "a";
        }
        return text;
    }

    /** One value of each gap: before the first, between two, behind the last. */
    List<Value> gaps() {
        if (values.isEmpty()) {
            return List.of(FirstValue.of(type));
        }
        List<Value> gaps = new ArrayList<>();
        if (type instanceof Type.IntegerType integer) {
            long next = integer.low();
            for (Value value : values) {
                long number = ((Value.IntegerValue) value).value();
                if (next < number && next <= integer.high()) {
                    gaps.add(new Value.IntegerValue(Math.min(number - 1, integer.high())));
                }
                next = Math.max(next, number == Long.MAX_VALUE ? number : number + 1);
            }
            long last = ((Value.IntegerValue) values.get(values.size() - 1)).value();
            if (last < integer.high()) {
                gaps.add(new Value.IntegerValue(Math.max(last + 1, integer.low())));
            }
        } else if (type instanceof Type.RealType) {
            double last = Double.NaN;
            for (Value value : values) {
                double number = ((Value.RealValue) value).value();
                gaps.add(
                        new Value.RealValue(Double.isNaN(last) ? number - 1 : (last + number) / 2));
                last = number;
            }
            gaps.add(new Value.RealValue(last + 1));
        } else if (type instanceof Type.CharacterType) {
            for (Value value : values) {
                char character = ((Value.CharacterValue) value).value();
                add((char) (character - 1), gaps);
                add((char) (character + 1), gaps);
            }
        }
        return gaps;
    }

    private void add(char character, List<Value> gaps) {
        Value value = new Value.CharacterValue(character);
        if (!values.contains(value) && !gaps.contains(value)) {
            gaps.add(value);
        }
    }
}
