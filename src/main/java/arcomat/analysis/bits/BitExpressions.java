package arcomat.analysis.bits;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.value.GivenUp;

import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * Expressions over the messages of a letter, each of which is there, in bits: exactly as the
 * interpreter has them. Truth values are one bit; constants of enumerations and characters are
 * their positions.
 */
final class BitExpressions implements Expression.SomeCases<int[]> {
    private final Circuit circuit;
    private final Map<String, int[]> messages = new HashMap<>();
    private final Map<Expression, int[]> known = new IdentityHashMap<>();

    BitExpressions(Circuit circuit) {
        this.circuit = circuit;
    }

    /**
     * @throws GivenUp where an expression is about something else
     */
    int[] bits(Expression e) {
        int[] bits = known.get(e);
        if (bits == null) {
            bits = e.match(this);
            known.put(e, bits);
        }
        return bits;
    }

    int truth(Expression condition) {
        return bits(condition)[0];
    }

    /** The bits of a message that may be any of its type. */
    int[] message(Port port) {
        return messages.computeIfAbsent(port.name(), name -> any(port.type()));
    }

    /** Of a type with a range only so many bits are open as it takes; the others are its sign. */
    private int[] any(Type type) {
        BitCodes codes = BitCodes.of(type);
        return Circuit.resized(
                circuit.input(Math.min(codes.needed(), codes.width())), codes.width());
    }

    /** Whether bits are those of a value of the type; all of them are, if they may be. */
    int isOf(int[] bits, Type type) {
        BitCodes codes = BitCodes.of(type);
        if (codes.isTruth()) {
            return circuit.of(true);
        }
        int[] least = circuit.constant(codes.least(), bits.length);
        int[] most = circuit.constant(codes.most(), bits.length);
        return circuit.and(-circuit.isLess(bits, least), -circuit.isLess(most, bits));
    }

    int[] value(Value value, Type type) {
        int width = BitCodes.of(type).width();
        return circuit.constant(BitCodes.code(value), width);
    }

    private static GivenUp noBits() {
        return new GivenUp("there are no bits for it");
    }

    @Override
    public int[] otherwise(Expression expression) {
        throw noBits();
    }

    @Override
    public int[] constant(Expression.Constant constant) {
        return value(constant.value(), constant.type());
    }

    @Override
    public int[] portRead(Expression.PortRead read) {
        return message(read.port());
    }

    @Override
    public int[] portMatches(Expression.PortMatches matches) {
        Expression read = new Expression.PortRead(matches.port(), matches.span());
        return one(
                matches.pattern()
                        .match(
                                oneOf -> isIn(read, oneOf.values()),
                                () -> circuit.of(false),
                                () -> circuit.of(true)));
    }

    @Override
    public int[] isIn(Expression.IsIn isIn) {
        return one(isIn(isIn.element(), isIn.set()));
    }

    private int isIn(Expression element, List<Expression> set) {
        int any = circuit.of(false);
        for (Expression each : set) {
            any = circuit.or(any, areEqual(element, each));
        }
        return any;
    }

    private static int[] one(int literal) {
        return new int[] {literal};
    }

    int areEqual(Expression one, Expression other) {
        int[] a = bits(one);
        int[] b = bits(other);
        if ((a.length == 1) != (b.length == 1)) {
            throw noBits();
        }
        int width = Math.max(a.length, b.length);
        return circuit.areEqual(Circuit.resized(a, width), Circuit.resized(b, width));
    }

    @Override
    public int[] conditional(Expression.Conditional choice) {
        int width = BitCodes.of(choice.type()).width();
        return circuit.choose(
                truth(choice.condition()),
                Circuit.resized(bits(choice.then()), width),
                Circuit.resized(bits(choice.otherwise()), width));
    }

    @Override
    public int[] cast(Expression.Cast cast) {
        int[] operand = bits(cast.operand());
        if (cast.type() instanceof Type.CharacterType) {
            int[] wide = Circuit.resized(operand, Integer.SIZE);
            for (int i = Character.SIZE; i < wide.length; i++) {
                wide[i] = circuit.of(false);
            }
            return wide;
        }
        if (cast.type() instanceof Type.IntegerType integer) {
            int kept =
                    switch (integer.width()) {
                        case BYTE -> Byte.SIZE;
                        case SHORT -> Short.SIZE;
                        case INT -> Integer.SIZE;
                        case LONG -> Long.SIZE;
                    };
            int[] narrow = Circuit.resized(operand, Math.min(kept, operand.length));
            return Circuit.resized(narrow, BitCodes.of(integer).width());
        }
        return Circuit.resized(operand, BitCodes.of(cast.type()).width());
    }

    @Override
    public int[] unary(Expression.Unary unary) {
        int[] operand = bits(unary.operand());
        return switch (unary.operator()) {
            case NOT -> one(-operand[0]);
            case NEGATE -> circuit.negated(sized(operand, unary.type()));
            case COMPLEMENT -> circuit.complement(sized(operand, unary.type()));
        };
    }

    private static int[] sized(int[] operand, Type type) {
        return Circuit.resized(operand, BitCodes.of(type).width());
    }

    @Override
    public int[] binary(Expression.Binary binary) {
        Expression left = binary.left();
        Expression right = binary.right();
        return switch (binary.operator()) {
            case EQUAL -> one(areEqual(left, right));
            case NOT_EQUAL -> one(-areEqual(left, right));
            case LESS -> one(isLess(left, right));
            case LESS_OR_EQUAL -> one(-isLess(right, left));
            case GREATER -> one(isLess(right, left));
            case GREATER_OR_EQUAL -> one(-isLess(left, right));
            case AND -> one(circuit.and(truth(left), truth(right)));
            case OR -> one(circuit.or(truth(left), truth(right)));
            case IMPLIES -> one(circuit.or(-truth(left), truth(right)));
            case EQUIVALENT -> one(-circuit.xor(truth(left), truth(right)));
            default -> arithmetic(binary);
        };
    }

    private int isLess(Expression one, Expression other) {
        int[] a = bits(one);
        int[] b = bits(other);
        int width = Math.max(a.length, b.length);
        return circuit.isLess(Circuit.resized(a, width), Circuit.resized(b, width));
    }

    private int[] arithmetic(Expression.Binary binary) {
        int[] left = sized(bits(binary.left()), binary.type());
        int[] right = sized(bits(binary.right()), binary.type());
        BinaryOperator operator = binary.operator();
        return switch (operator) {
            case PLUS -> circuit.sum(left, right);
            case MINUS -> circuit.difference(left, right);
            case MULTIPLY -> circuit.product(left, right);
            case DIVIDE -> circuit.divided(left, right).quotient();
            case REMAINDER -> circuit.divided(left, right).rest();
            default -> throw noBits();
        };
    }
}
