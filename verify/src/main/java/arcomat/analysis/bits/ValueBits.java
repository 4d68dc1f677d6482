package arcomat.analysis.bits;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * Values of types as bits of a circuit. Those of an object are those of its attributes, one behind
 * the other: two objects with the same attributes are the same message.
 *
 * @param texts the numbers of texts
 */
record ValueBits(Circuit circuit, TextCodes texts) {
    private BitCodes codes(Type type) {
        return BitCodes.of(type, texts);
    }

    int width(Type type) {
        return type instanceof Type.ClassType object
                ? object.attributes().stream().mapToInt(each -> width(each.type())).sum()
                : codes(type).width();
    }

    /** Attribute by attribute. */
    private static int[] joined(Type.ClassType type, IntFunction<int[]> part) {
        return attributes(type).mapToObj(part).flatMapToInt(Arrays::stream).toArray();
    }

    private static IntStream attributes(Type.ClassType type) {
        return IntStream.range(0, type.attributes().size());
    }

    private static Type typeOf(Type.ClassType type, int attribute) {
        return type.attributes().get(attribute).type();
    }

    /** The bits of an attribute. */
    int[] part(int[] object, Type.ClassType type, int attribute) {
        int from = IntStream.range(0, attribute).map(before -> width(typeOf(type, before))).sum();
        return Arrays.copyOfRange(object, from, from + width(typeOf(type, attribute)));
    }

    int[] of(Value value, Type type) {
        if (type instanceof Type.ClassType object) {
            List<Value> attributes = ((Value.ObjectValue) value).attributes();
            return joined(object, i -> of(attributes.get(i), typeOf(object, i)));
        }
        BitCodes codes = codes(type);
        return circuit.constant(codes.code().applyAsLong(value), codes.width());
    }

    /** Of a type with a range only so many bits are open as it takes; the others are its sign. */
    int[] any(Type type) {
        if (type instanceof Type.ClassType object) {
            return joined(object, i -> any(typeOf(object, i)));
        }
        BitCodes codes = codes(type);
        return Circuit.resized(
                circuit.input(Math.min(codes.needed(), codes.width())), codes.width());
    }

    /** Whether bits are those of a value of the type; all of them are, if they may be. */
    int isOf(int[] bits, Type type) {
        if (type instanceof Type.ClassType object) {
            return circuit.and(
                    attributes(object).map(i -> isOf(part(bits, object, i), typeOf(object, i))));
        }
        BitCodes codes = codes(type);
        if (codes.isTruth()) {
            return circuit.of(true);
        }
        if (type instanceof Type.RealType real) {
            return reals(real).isPattern(bits);
        }
        int[] least = circuit.constant(codes.least(), bits.length);
        int[] most = circuit.constant(codes.most(), bits.length);
        return circuit.and(-circuit.isLess(bits, least), -circuit.isLess(most, bits));
    }

    /** Literals that make a number one of so many bits, which is easy to read. */
    IntStream areBelow(int[] bits, Type type, int width) {
        if (type instanceof Type.ClassType object) {
            return attributes(object)
                    .flatMap(i -> areBelow(part(bits, object, i), typeOf(object, i), width));
        }
        return type instanceof Type.RealType real
                ? IntStream.of(reals(real).isShort(bits, width))
                : Arrays.stream(bits).skip(width).map(bit -> -bit);
    }

    /** Of any value of a type, and of nothing else. */
    int[] some(Type type) {
        int[] bits = any(type);
        return circuit.choose(isOf(bits, type), bits, of(type.first(), type));
    }

    /** The value that bits stand for, of which it is known whether they are true. */
    Value meaning(int[] bits, Type type, IntPredicate isTrue) {
        if (type instanceof Type.ClassType object) {
            return new Value.ObjectValue(
                    object,
                    attributes(object)
                            .mapToObj(
                                    i -> meaning(part(bits, object, i), typeOf(object, i), isTrue))
                            .toList());
        }
        long number = 0;
        for (int i = 0; i < bits.length; i++) {
            if (isTrue.test(bits[i])) {
                number |= 1L << i;
            }
        }
        return codes(type).meaning().apply(bits.length == Integer.SIZE ? (int) number : number);
    }

    /** The arithmetic of a type of numbers of floating point. */
    FloatingPoint reals(Type.RealType type) {
        return new FloatingPoint(circuit, RealFormat.of(type));
    }
}
