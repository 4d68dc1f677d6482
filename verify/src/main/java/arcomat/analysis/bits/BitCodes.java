package arcomat.analysis.bits;

import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.value.GivenUp;

import java.util.function.LongFunction;
import java.util.function.ToLongFunction;

/**
 * The values of a type as numbers: constants of enumerations and characters have their position,
 * truth values are 0 and 1. Numbers of floating point are what Java has in memory, texts have
 * numbers of their own.
 *
 * @param width how many bits Java's arithmetic has for them
 * @param meaning the value that a number is the code of
 * @param code the number of a value
 */
record BitCodes(
        int width, long least, long most, LongFunction<Value> meaning, ToLongFunction<Value> code) {
    private static final BitCodes TRUTHS =
            new BitCodes(
                    1,
                    0,
                    1,
                    number -> new Value.BooleanValue(number != 0),
                    value -> ((Value.BooleanValue) value).value() ? 1 : 0);
    private static final BitCodes CHARACTERS =
            new BitCodes(
                    Integer.SIZE,
                    0,
                    Character.MAX_VALUE,
                    number -> new Value.CharacterValue((char) number),
                    Value::whole);

    /**
     * @param texts the numbers of texts
     * @throws GivenUp for objects
     */
    static BitCodes of(Type type, TextCodes texts) {
        return type.match(new OfTypes(texts));
    }

    boolean isTruth() {
        return width == 1;
    }

    /** So many bits tell all of them apart; those above are copies of the sign. */
    int needed() {
        long farthest = Math.max(most, -1 - least);
        return isTruth() ? 1 : Long.SIZE - Long.numberOfLeadingZeros(farthest) + 1;
    }

    private record OfTypes(TextCodes texts) implements Type.Cases<BitCodes> {
        @Override
        public BitCodes booleanType(Type.BooleanType type) {
            return TRUTHS;
        }

        @Override
        public BitCodes integerType(Type.IntegerType type) {
            return new BitCodes(
                    type.width() == Type.Width.LONG ? Long.SIZE : Integer.SIZE,
                    type.low(),
                    type.high(),
                    Value.IntegerValue::new,
                    Value::whole);
        }

        @Override
        public BitCodes characterType(Type.CharacterType type) {
            return CHARACTERS;
        }

        @Override
        public BitCodes enumType(Type.EnumType type) {
            return new BitCodes(
                    Integer.SIZE,
                    0,
                    type.constants().size() - 1L,
                    number -> new Value.EnumValue(type, (int) number),
                    value -> ((Value.EnumValue) value).ordinal());
        }

        @Override
        public BitCodes realType(Type.RealType type) {
            RealFormat format = RealFormat.of(type);
            return new BitCodes(
                    format.width(),
                    Long.MIN_VALUE,
                    Long.MAX_VALUE,
                    code -> new Value.RealValue(format.real(code)),
                    value -> code(value, type));
        }

        private static long code(Value value, Type.RealType type) {
            if (value instanceof Value.RealValue real && type.has(value)) {
                return RealFormat.of(type).code(real.value());
            }
            throw new GivenUp("%s is no %s".formatted(value, type.name()));
        }

        @Override
        public BitCodes stringType(Type.StringType type) {
            return new BitCodes(Integer.SIZE, 0, TextCodes.MOST, texts::text, texts::code);
        }

        @Override
        public BitCodes classType(Type.ClassType type) {
            throw new GivenUp("there are no bits for values of " + type.name());
        }
    }
}
