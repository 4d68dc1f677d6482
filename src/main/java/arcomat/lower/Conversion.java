package arcomat.lower;

import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Value;

/** Makes the widening of numbers explicit. */
final class Conversion {
    private Conversion() {}

    /** The expression in another type; ranges make no difference, constants convert at once. */
    static Expression to(Type target, Expression expression) {
        Type carrier = carrier(target);
        if (carrier(expression.type()).equals(carrier) || !carrier.isNumber()) {
            return expression;
        }
        if (expression instanceof Expression.Constant constant) {
            return new Expression.Constant(
                    convert(constant.value(), carrier), carrier, constant.span());
        }
        return new Expression.Cast(expression, carrier, expression.span());
    }

    /** The type without its range. */
    static Type carrier(Type type) {
        return type instanceof Type.IntegerType integer
                ? Type.IntegerType.of(integer.width())
                : type;
    }

    /** A number converted by the rules of Java. */
    static Value convert(Value value, Type target) {
        if (target instanceof Type.RealType real) {
            double number = real(value);
            return new Value.RealValue(real.rounded(number));
        }
        if (target instanceof Type.CharacterType) {
            return new Value.CharacterValue((char) whole(value, Type.Width.INT));
        }
        Type.Width width = ((Type.IntegerType) target).width();
        return new Value.IntegerValue(wrap(whole(value, width), width));
    }

    static double real(Value value) {
        return value instanceof Value.RealValue real ? real.value() : whole(value, Type.Width.LONG);
    }

    /** Java rounds reals towards zero, to an int for the narrow types, and saturates. */
    private static long whole(Value value, Type.Width width) {
        if (value instanceof Value.RealValue real) {
            return width == Type.Width.LONG ? (long) real.value() : (int) real.value();
        }
        return value.whole();
    }

    static long wrap(long value, Type.Width width) {
        return switch (width) {
            case BYTE -> (byte) value;
            case SHORT -> (short) value;
            case INT -> (int) value;
            case LONG -> value;
        };
    }
}
