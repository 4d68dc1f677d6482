package arcomat.simulate.run;

import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.rt.Choice;

/**
 * Values of a type, drawn at random: finite types evenly; of the others mostly small values, so
 * that the constants in guards are met, and now and then an extreme one.
 */
final class RandomValues {
    private static final int SMALL = 12;

    /** What a sensor may well send that divides by what it measures. */
    private static final double[] UNUSUAL = {
        Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, -0.0
    };

    private RandomValues() {}

    static Value draw(Type type, Choice generator) {
        if (type instanceof Type.BooleanType) {
            return new Value.BooleanValue(generator.next(2) == 1);
        }
        if (type instanceof Type.IntegerType integer) {
            return new Value.IntegerValue(integer(integer, generator));
        }
        if (type instanceof Type.RealType) {
            return new Value.RealValue(real(generator));
        }
        if (type instanceof Type.CharacterType) {
            return new Value.CharacterValue((char) ('a' + generator.next(26)));
        }
        if (type instanceof Type.StringType) {
            return new Value.StringValue(string(generator));
        }
        if (type instanceof Type.EnumType enumeration) {
            int ordinal = generator.next(enumeration.constants().size());
            return new Value.EnumValue(enumeration, ordinal);
        }
        if (type instanceof Type.ClassType object) {
            return new Value.ObjectValue(
                    object,
                    object.attributes().stream().map(a -> draw(a.type(), generator)).toList());
        }
        throw new AssertionError(type);
    }

    /** Of few digits, so that single precision holds it, too. */
    private static double real(Choice generator) {
        int number = generator.next(8 * SMALL + 1 + UNUSUAL.length);
        return number < UNUSUAL.length
                ? UNUSUAL[number]
                : (number - UNUSUAL.length - 4 * SMALL) / 4.0;
    }

    private static long integer(Type.IntegerType type, Choice generator) {
        long size = type.high() - type.low() + 1;
        if (size > 0 && size <= Integer.MAX_VALUE) {
            return type.ranged() || size <= 1 << Byte.SIZE
                    ? type.low() + generator.next((int) size)
                    : small(type, generator);
        }
        return small(type, generator);
    }

    private static long small(Type.IntegerType type, Choice generator) {
        return switch (generator.next(40)) {
            case 0 -> type.low();
            case 1 -> type.high();
            default -> {
                long value = generator.next(2 * SMALL + 1) - SMALL;
                yield Math.max(type.low(), Math.min(type.high(), value));
            }
        };
    }

    private static String string(Choice generator) {
        StringBuilder text = new StringBuilder();
        for (int length = generator.next(4); length > 0; length--) {
            text.append((char) ('a' + generator.next(3)));
        }
        return text.toString();
    }
}
