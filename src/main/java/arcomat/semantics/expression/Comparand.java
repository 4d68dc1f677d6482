package arcomat.semantics.expression;

import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Type.Width;
import arcomat.model.Value;

import java.util.List;
import java.util.Optional;

/**
 * A comparison of a message with a value, in terms of the port's type: Java compares small numbers
 * and characters as wider numbers, which changes neither what is equal nor what is less.
 */
final class Comparand {
    private Comparand() {}

    /** The port that an expression reads, as it is or exactly converted. */
    static Optional<Port> port(Expression e) {
        return exact(e) instanceof Expression.PortRead read
                ? Optional.of(read.port())
                : Optional.empty();
    }

    /** An expression without the exact conversions around it. */
    static Expression exact(Expression e) {
        return e instanceof Expression.Cast cast && isExact(cast.operand().type(), cast.type())
                ? exact(cast.operand())
                : e;
    }

    /**
     * Whether an expression is a conversion that gives the same value, as values of messages and
     * variables are kept.
     */
    static boolean isCopy(Expression e) {
        return e instanceof Expression.Cast cast
                && cast.operand().type() instanceof Type.IntegerType
                && cast.type() instanceof Type.IntegerType
                && isExact(cast.operand().type(), cast.type());
    }

    private static boolean isExact(Type from, Type to) {
        if (to instanceof Type.RealType real) {
            return from instanceof Type.RealType other
                    ? other.single() || !real.single()
                    : width(from).compareTo(real.single() ? Width.SHORT : Width.INT) <= 0;
        }
        return to instanceof Type.IntegerType integer
                && !(from instanceof Type.RealType)
                && width(from).compareTo(integer.width()) <= 0;
    }

    /** Characters need more than the positive half of a short. */
    private static Width width(Type type) {
        return type instanceof Type.IntegerType integer ? integer.width() : Width.INT;
    }

    /**
     * The value of a type that divides its values as another value does: all others are less than
     * both, or greater than both. Empty where the other value divides nothing.
     */
    static List<Value> in(Type type, Value value) {
        if (type instanceof Type.RealType real) {
            double number = Arithmetic.real(value);
            double rounded = real.rounded(number);
            // There is only one zero: -0.0 equals 0.0.
            return Double.isNaN(rounded) ? List.of() : List.of(new Value.RealValue(rounded + 0.0));
        }
        return isKept(type, value) ? List.of(value) : below(type, Arithmetic.real(value));
    }

    /** Whether values of a type that is not of real numbers are kept as this one is. */
    private static boolean isKept(Type type, Value value) {
        return !type.isNumber()
                || (type instanceof Type.IntegerType
                        ? value instanceof Value.IntegerValue
                        : value instanceof Value.CharacterValue);
    }

    /** The greatest integer or character that is not greater. */
    private static List<Value> below(Type type, double real) {
        double number = Math.floor(real);
        if (type instanceof Type.IntegerType) {
            return Double.isNaN(number)
                    ? List.of()
                    : List.of(new Value.IntegerValue((long) number));
        }
        return Character.MIN_VALUE <= number && number <= Character.MAX_VALUE
                ? List.of(new Value.CharacterValue((char) number))
                : List.of();
    }
}
