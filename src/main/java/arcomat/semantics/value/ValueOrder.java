package arcomat.semantics.value;

import arcomat.model.Value;

import java.util.Comparator;

/**
 * An order of the values of one type: numbers by size, constants by declaration, all else by its
 * text.
 */
public final class ValueOrder {
    public static final Comparator<Value> NATURAL = ValueOrder::compare;

    private ValueOrder() {}

    private static int compare(Value one, Value other) {
        if (one instanceof Value.IntegerValue left && other instanceof Value.IntegerValue right) {
            return Long.compare(left.value(), right.value());
        }
        if (one instanceof Value.RealValue left && other instanceof Value.RealValue right) {
            return Double.compare(left.value(), right.value());
        }
        if (one instanceof Value.CharacterValue left
                && other instanceof Value.CharacterValue right) {
            return Character.compare(left.value(), right.value());
        }
        if (one instanceof Value.EnumValue left && other instanceof Value.EnumValue right) {
            return Integer.compare(left.ordinal(), right.ordinal());
        }
        return one.toString().compareTo(other.toString());
    }
}
