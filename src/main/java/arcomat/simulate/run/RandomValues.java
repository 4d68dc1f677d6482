package arcomat.simulate.run;

import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.rt.Choice;

/**
 * Values of a type, drawn at random: finite types evenly; of the others mostly small values, so
 * that the constants in guards are met, and now and then an extreme one.
 */
final class RandomValues implements Type.Cases<Value> {
    private static final int SMALL = 12;

    /** What a sensor may well send that divides by what it measures. */
    private static final double[] UNUSUAL = {
        Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, -0.0
    };

    private final Choice generator;

    private RandomValues(Choice generator) {
        this.generator = generator;
    }

    static Value draw(Type type, Choice generator) {
        return type.match(new RandomValues(generator));
    }

    @Override
    public Value booleanType(Type.BooleanType type) {
        return new Value.BooleanValue(generator.next(2) == 1);
    }

    @Override
    public Value integerType(Type.IntegerType type) {
        return new Value.IntegerValue(integer(type));
    }

    @Override
    public Value realType(Type.RealType type) {
        return new Value.RealValue(real());
    }

    @Override
    public Value characterType(Type.CharacterType type) {
        return new Value.CharacterValue((char) ('a' + generator.next(26)));
    }

    @Override
    public Value stringType(Type.StringType type) {
        return new Value.StringValue(string());
    }

    @Override
    public Value enumType(Type.EnumType type) {
        return new Value.EnumValue(type, generator.next(type.constants().size()));
    }

    @Override
    public Value classType(Type.ClassType type) {
        return new Value.ObjectValue(
                type, type.attributes().stream().map(each -> each.type().match(this)).toList());
    }

    /** Of few digits, so that single precision holds it, too. */
    private double real() {
        int number = generator.next(8 * SMALL + 1 + UNUSUAL.length);
        return number < UNUSUAL.length
                ? UNUSUAL[number]
                : (number - UNUSUAL.length - 4 * SMALL) / 4.0;
    }

    private long integer(Type.IntegerType type) {
        long size = type.high() - type.low() + 1;
        if (size > 0 && size <= Integer.MAX_VALUE) {
            return type.ranged() || size <= 1 << Byte.SIZE
                    ? type.low() + generator.next((int) size)
                    : small(type);
        }
        return small(type);
    }

    private long small(Type.IntegerType type) {
        return switch (generator.next(40)) {
            case 0 -> type.low();
            case 1 -> type.high();
            default -> {
                long value = (long) generator.next(2 * SMALL + 1) - SMALL;
                yield Math.max(type.low(), Math.min(type.high(), value));
            }
        };
    }

    private String string() {
        StringBuilder text = new StringBuilder();
        for (int length = generator.next(4); length > 0; length--) {
            text.append((char) ('a' + generator.next(3)));
        }
        return text.toString();
    }
}
