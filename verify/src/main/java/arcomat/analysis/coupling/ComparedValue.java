package arcomat.analysis.coupling;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.Optional;

/**
 * What a variable is compared with: a value, or another variable, perhaps the opposite of it, and,
 * of whole numbers, a number more. Their sums are those of 64 bits.
 *
 * @param variable empty for a value
 * @param plus 0 where nothing is added
 * @param value of no matter where there is a variable
 */
record ComparedValue(Optional<Port> variable, boolean opposite, long plus, Value value) {
    private static final Type WIDE = Type.IntegerType.of(Type.Width.LONG);
    private static final Value NOTHING = new Value.IntegerValue(0);

    static ComparedValue of(Value value) {
        return new ComparedValue(Optional.empty(), false, 0, value);
    }

    static ComparedValue of(Port variable, boolean opposite, long plus) {
        return new ComparedValue(Optional.of(variable), opposite, plus, NOTHING);
    }

    boolean isCalculated() {
        return opposite || plus != 0;
    }

    /**
     * @param type of what is compared with it
     */
    @SuppressWarnings("NullAway") // it stands in no model
    Expression expression(Type type) {
        if (variable.isEmpty()) {
            return new Expression.Constant(value, holding(type), null);
        }
        Expression read = new Expression.PortRead(variable.get(), null);
        if (!isCalculated()) {
            return read;
        }
        boolean isReal = type instanceof Type.RealType;
        Expression wide = isReal ? read : new Expression.Cast(read, WIDE, null);
        Expression signed =
                opposite
                        ? new Expression.Unary(
                                Expression.UnaryOperator.NEGATE, wide, wide.type(), null)
                        : wide;
        Expression number = new Expression.Constant(new Value.IntegerValue(plus), WIDE, null);
        return plus == 0
                ? signed
                : new Expression.Binary(BinaryOperator.PLUS, signed, number, WIDE, null);
    }

    /** A type that has the value: in one that is too narrow for it, bits of it would be lost. */
    private Type holding(Type type) {
        return type instanceof Type.IntegerType && !type.has(value) ? WIDE : type;
    }

    @Override
    public String toString() {
        if (variable.isEmpty()) {
            return value.toString();
        }
        String sum = plus == 0 ? "" : plus < 0 ? " - " + Math.abs(plus) : " + " + plus;
        return (opposite ? "-" : "") + variable.get().name() + sum;
    }
}
