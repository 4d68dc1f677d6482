package arcomat.semantics.expression;

import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;

/**
 * Java's arithmetic on values: 32 or 64 bit integers that wrap around, single or double precision.
 * The operands decide which; both have one type.
 */
final class Arithmetic {
    private Arithmetic() {}

    /** Whether an operand is calculated with in 64 bits. */
    private static boolean isLong(Type type) {
        return type instanceof Type.IntegerType integer && integer.width() == Type.Width.LONG;
    }

    private static boolean isSingle(Type type) {
        return type instanceof Type.RealType real && real.single();
    }

    static double real(Value value) {
        return value instanceof Value.RealValue real ? real.value() : value.whole();
    }

    static Value calculate(BinaryOperator operator, Value left, Value right, Type type) {
        if (type instanceof Type.RealType) {
            // Of single numbers, the rounded double result is the single one (Figueroa 1995).
            return new Value.RealValue(
                    isSingle(type)
                            ? (float) onReals(operator, (float) real(left), (float) real(right))
                            : onReals(operator, real(left), real(right)));
        }
        long result = onIntegers(operator, left.whole(), right.whole());
        return new Value.IntegerValue(isLong(type) ? result : (int) result);
    }

    private static long onIntegers(BinaryOperator operator, long a, long b) {
        return switch (operator) {
            case MULTIPLY -> a * b;
            case DIVIDE -> a / nonZero(b);
            case REMAINDER -> a % nonZero(b);
            case PLUS -> a + b;
            case MINUS -> a - b;
            default -> throw new AssertionError(operator);
        };
    }

    private static long nonZero(long divisor) {
        if (divisor == 0) {
            throw Fault.divisionByZero();
        }
        return divisor;
    }

    private static double onReals(BinaryOperator operator, double a, double b) {
        return switch (operator) {
            case MULTIPLY -> a * b;
            case DIVIDE -> a / b;
            case REMAINDER -> a % b;
            case PLUS -> a + b;
            case MINUS -> a - b;
            default -> throw new AssertionError(operator);
        };
    }

    static boolean compare(BinaryOperator operator, Value left, Value right) {
        if (left instanceof Value.RealValue || right instanceof Value.RealValue) {
            double a = real(left);
            double b = real(right);
            return compare(operator, a < b, a == b, a > b); // none of them holds of NaN
        }
        int order = Long.compare(left.whole(), right.whole());
        return compare(operator, order < 0, order == 0, order > 0);
    }

    private static boolean compare(
            BinaryOperator operator, boolean less, boolean equal, boolean greater) {
        return switch (operator) {
            case LESS -> less;
            case LESS_OR_EQUAL -> less || equal;
            case GREATER -> greater;
            case GREATER_OR_EQUAL -> greater || equal;
            default -> throw new AssertionError(operator);
        };
    }

    /** Numbers as Java's {@code ==} has them, everything else by content. */
    static boolean equal(Value left, Value right) {
        if (left instanceof Value.RealValue || right instanceof Value.RealValue) {
            return real(left) == real(right);
        }
        if (left instanceof Value.CharacterValue || right instanceof Value.CharacterValue) {
            return left.whole() == right.whole();
        }
        return left.equals(right);
    }

    static Value negate(Value value, Type type) {
        if (value instanceof Value.RealValue real) {
            return new Value.RealValue(-real.value());
        }
        long negated = -value.whole();
        return new Value.IntegerValue(isLong(type) ? negated : (int) negated);
    }

    static Value complement(Value value) {
        return new Value.IntegerValue(~value.whole());
    }

    /** A numeric conversion with Java's rules; a range does not narrow. */
    static Value cast(Value value, Type target) {
        if (!target.isNumber()) {
            return value;
        }
        if (target instanceof Type.RealType real) {
            if (value instanceof Value.RealValue from) {
                return new Value.RealValue(real.rounded(from.value()));
            }
            long whole = value.whole();
            return new Value.RealValue(real.single() ? (float) whole : (double) whole);
        }
        return target instanceof Type.IntegerType integer
                ? new Value.IntegerValue(whole(value, integer.width()))
                : new Value.CharacterValue((char) whole(value, Type.Width.INT));
    }

    private static long whole(Value value, Type.Width width) {
        if (width == Type.Width.LONG) {
            return value instanceof Value.RealValue real ? (long) real.value() : value.whole();
        }
        int number =
                value instanceof Value.RealValue real ? (int) real.value() : (int) value.whole();
        return switch (width) {
            case BYTE -> (byte) number;
            case SHORT -> (short) number;
            case INT, LONG -> number;
        };
    }

    /** As Java's string concatenation has it. */
    static String text(Value value, Type type) {
        if (value instanceof Value.StringValue string) {
            return string.value();
        }
        if (value instanceof Value.CharacterValue character) {
            return String.valueOf(character.value());
        }
        return isSingle(type)
                ? String.valueOf((float) ((Value.RealValue) value).value())
                : value.toString();
    }
}
