package arcomat.analysis.automaton;

import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;

import java.math.BigInteger;
import java.util.List;
import java.util.function.Function;

/** Types, values and operations as SMT-LIB writes them: vectors of bits, and IEEE 754. */
final class SmtLib {
    private SmtLib() {}

    static String onIntegers(BinaryOperator operator, String left, String right) {
        return switch (operator) {
            case PLUS -> apply("bvadd", left, right);
            case MINUS -> apply("bvsub", left, right);
            case MULTIPLY -> apply("bvmul", left, right);
            case DIVIDE -> apply("bvsdiv", left, right);
            case REMAINDER -> apply("bvsrem", left, right);
            case LESS -> apply("bvslt", left, right);
            case LESS_OR_EQUAL -> apply("bvsle", left, right);
            case GREATER -> apply("bvsgt", left, right);
            case GREATER_OR_EQUAL -> apply("bvsge", left, right);
            case EQUAL -> same(left, right);
            case NOT_EQUAL -> not(same(left, right));
            default -> throw new AssertionError(operator);
        };
    }

    static String onReals(BinaryOperator operator, String left, String right) {
        return switch (operator) {
            case PLUS -> apply("fp.add RNE", left, right);
            case MINUS -> apply("fp.sub RNE", left, right);
            case MULTIPLY -> apply("fp.mul RNE", left, right);
            case DIVIDE -> apply("fp.div RNE", left, right);
            case LESS -> apply("fp.lt", left, right);
            case LESS_OR_EQUAL -> apply("fp.leq", left, right);
            case GREATER -> apply("fp.gt", left, right);
            case GREATER_OR_EQUAL -> apply("fp.geq", left, right);
            case EQUAL -> apply("fp.eq", left, right);
            case NOT_EQUAL -> not(apply("fp.eq", left, right));
            default -> throw new AssertionError(operator);
        };
    }

    /** Computed with twice as many bits, it is another number. */
    static String differs(
            BinaryOperator operator, String left, String right, String result, int bits) {
        if (operator == BinaryOperator.REMAINDER) {
            return "false";
        }
        Function<String, String> wide = value -> "((_ sign_extend " + bits + ") " + value + ")";
        String exact = onIntegers(operator, wide.apply(left), wide.apply(right));
        String differs = not(same(exact, wide.apply(result)));
        return operator == BinaryOperator.DIVIDE
                ? conjunction(List.of(not(same(right, vector(0, bits))), differs))
                : differs;
    }

    static String extended(String value, Type type, int bits) {
        String extend = type instanceof Type.CharacterType ? "zero_extend" : "sign_extend";
        return "((_ %s %d) %s)".formatted(extend, bits - bits(type), value);
    }

    static String isWithin(String value, Type.IntegerType type) {
        int bits = bits(type);
        return "(and (bvsle %s %s) (bvsle %s %s))"
                .formatted(vector(type.low(), bits), value, value, vector(type.high(), bits));
    }

    static String convert(Type type) {
        return ((Type.RealType) type).single() ? "(_ to_fp 8 24)" : "(_ to_fp 11 53)";
    }

    static String sort(Type type) {
        if (type instanceof Type.BooleanType) {
            return "Bool";
        }
        if (type instanceof Type.RealType real) {
            return real.single() ? "(_ FloatingPoint 8 24)" : "(_ FloatingPoint 11 53)";
        }
        return "(_ BitVec " + bits(type) + ")";
    }

    static int bits(Type type) {
        if (type instanceof Type.CharacterType) {
            return Character.SIZE;
        }
        return switch (((Type.IntegerType) type).width()) {
            case BYTE -> Byte.SIZE;
            case SHORT -> Short.SIZE;
            case INT -> Integer.SIZE;
            case LONG -> Long.SIZE;
        };
    }

    static String literal(Value value, Type type) {
        if (value instanceof Value.BooleanValue truth) {
            return String.valueOf(truth.value());
        }
        if (value instanceof Value.RealValue real) {
            boolean single = ((Type.RealType) type).single();
            String bits =
                    single
                            ? "#x%08x".formatted(Float.floatToIntBits((float) real.value()))
                            : "#x%016x".formatted(Double.doubleToLongBits(real.value()));
            return "(" + convert(type) + " " + bits + ")";
        }
        long number =
                value instanceof Value.CharacterValue character
                        ? character.value()
                        : ((Value.IntegerValue) value).value();
        return vector(number, bits(type));
    }

    static String vector(long number, int bits) {
        return vector(BigInteger.valueOf(number), bits);
    }

    static String vector(BigInteger number, int bits) {
        return "(_ bv" + number.mod(BigInteger.ONE.shiftLeft(bits)) + " " + bits + ")";
    }

    static String apply(String function, String left, String right) {
        return "(" + function + " " + left + " " + right + ")";
    }

    static String same(String one, String two) {
        return apply("=", one, two);
    }

    static String not(String condition) {
        return "(not " + condition + ")";
    }

    static String conjunction(List<String> all) {
        return "(and true " + String.join(" ", all) + ")";
    }

    static String disjunction(List<String> any) {
        return "(or false " + String.join(" ", any) + ")";
    }
}
