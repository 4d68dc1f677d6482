package arcomat.analysis.search.letter;

import arcomat.model.Type;
import arcomat.model.Value;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;

/**
 * The numbers or characters between two others, both excluded.
 *
 * @param low null where it has no beginning but that of the type
 * @param high null where it has no end but that of the type
 */
record OpenInterval(Type type, @Nullable Value low, @Nullable Value high) {

    /**
     * All gaps, perhaps empty.
     *
     * @param values at least one, in their natural order; what is no number stands last
     */
    static List<OpenInterval> between(Type type, List<Value> values) {
        List<OpenInterval> gaps = new ArrayList<>();
        Value low = null;
        for (Value value : values) {
            if (!isNoNumber(value)) {
                gaps.add(new OpenInterval(type, low, value));
                low = value;
            }
        }
        gaps.add(new OpenInterval(type, low, null));
        return gaps;
    }

    private static boolean isNoNumber(Value value) {
        return value instanceof Value.RealValue real && Double.isNaN(real.value());
    }

    /** Some of its values, those near to its low end first; fewer where it has no more. */
    List<Value> first(int count) {
        List<Value> found = new ArrayList<>();
        if (type instanceof Type.RealType real) {
            reals(real, count, found);
        } else {
            wholes(count, found);
        }
        return found;
    }

    /** A guard may compare with numbers that the type does not have: they only end a gap. */
    private void wholes(int count, List<Value> found) {
        if (low != null && whole(low) >= highest() || high != null && whole(high) <= lowest()) {
            return;
        }
        long least = low == null ? lowest() : Math.max(lowest(), whole(low) + 1);
        long most = high == null ? highest() : Math.min(highest(), whole(high) - 1);
        if (low == null && high != null) {
            for (long number = most; number >= least && found.size() < count; number--) {
                found.add(value(number));
                if (number == Long.MIN_VALUE) {
                    return;
                }
            }
            return;
        }
        for (long number = least; number <= most && found.size() < count; number++) {
            found.add(value(number));
            if (number == Long.MAX_VALUE) {
                return;
            }
        }
    }

    private long lowest() {
        return type instanceof Type.IntegerType integer ? integer.low() : Character.MIN_VALUE;
    }

    private long highest() {
        return type instanceof Type.IntegerType integer ? integer.high() : Character.MAX_VALUE;
    }

    private static long whole(Value value) {
        return value instanceof Value.CharacterValue character
                ? character.value()
                : ((Value.IntegerValue) value).value();
    }

    private Value value(long number) {
        return type instanceof Type.CharacterType
                ? new Value.CharacterValue((char) number)
                : new Value.IntegerValue(number);
    }

    private void reals(Type.RealType real, int count, List<Value> found) {
        double end = high == null ? Double.POSITIVE_INFINITY : real(high);
        if (low == null || real(low) == Double.NEGATIVE_INFINITY) {
            double number = below(real, end);
            while (number > Double.NEGATIVE_INFINITY && found.size() < count) {
                found.add(new Value.RealValue(number + 0.0));
                number = below(real, number);
            }
            return;
        }
        double number = above(real, real(low), end);
        while (number < end && found.size() < count) {
            found.add(new Value.RealValue(number + 0.0));
            number = above(real, number, end);
        }
    }

    private static double real(Value value) {
        return ((Value.RealValue) value).value();
    }

    /** One more, or else the next one. */
    private static double above(Type.RealType type, double number, double end) {
        double wanted = type.rounded(number + 1);
        if (number < wanted && wanted < end) {
            return wanted;
        }
        return type.above(number);
    }

    private static double below(Type.RealType type, double number) {
        double start = Double.isInfinite(number) ? 0 : number;
        double wanted = type.rounded(start - 1);
        if (wanted < number) {
            return wanted;
        }
        return type.below(number);
    }
}
