package arcomat.analysis.bits;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.ExpressionText;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.semantics.expression.Interval;
import arcomat.semantics.value.GivenUp;

import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Expressions at one point of a run, in bits: exactly as the interpreter has them, but for {@link
 * UnknownResults}. Truth values are one bit; constants of enumerations and characters are their
 * positions, numbers of floating point what Java has in memory, texts have {@linkplain TextCodes
 * numbers of their own}, objects are their attributes.
 */
final class BitExpressions implements Expression.SomeCases<int[]> {
    private final Circuit circuit;
    private final ValueBits values;
    private final BitReads reads;
    private final UnknownResults unknown = new UnknownResults();
    private final Map<String, int[]> messages = new HashMap<>();
    private final Map<Expression, int[]> known = new IdentityHashMap<>();

    BitExpressions(ValueBits values, BitReads reads) {
        this.circuit = values.circuit();
        this.values = values;
        this.reads = reads;
    }

    /**
     * @throws GivenUp where an expression is about something else
     */
    int[] bits(Expression e) {
        int[] bits = known.get(e);
        if (bits == null) {
            bits = said(e);
            known.put(e, bits);
        }
        return bits;
    }

    private int[] said(Expression e) {
        try {
            return e.match(this);
        } catch (GivenUp noBits) {
            return reads.instead(e, noBits);
        }
    }

    int truth(Expression condition) {
        return bits(condition)[0];
    }

    /** The bits of a message that may be any of its type. */
    int[] message(Port port) {
        return messages.computeIfAbsent(port.name(), name -> values.any(port.type()));
    }

    /** Both carry the same message, whatever it is; the second one has not been read so far. */
    void join(Port one, Port other) {
        messages.put(other.name(), message(one));
    }

    /** What has been taken for unknown. */
    UnknownResults unknown() {
        return unknown;
    }

    /** Where both are numbers of floating point, their arithmetic; nothing where neither is one. */
    private Optional<FloatingPoint> reals(Expression one, Expression other) {
        requireAlike(other.type(), one);
        return one.type() instanceof Type.RealType real
                ? Optional.of(values.reals(real))
                : Optional.empty();
    }

    static GivenUp noBits(Expression e) {
        return new GivenUp("there are no bits for '%s'".formatted(ExpressionText.of(e)));
    }

    @Override
    public int[] otherwise(Expression expression) {
        throw noBits(expression);
    }

    @Override
    public int[] constant(Expression.Constant constant) {
        return values.of(constant.value(), constant.type());
    }

    @Override
    public int[] portRead(Expression.PortRead read) {
        return message(read.port());
    }

    @Override
    public int[] variableRead(Expression.VariableRead read) {
        return reads.variable(read);
    }

    @Override
    public int[] parameterRead(Expression.ParameterRead read) {
        return values.of(reads.argument(read), read.type());
    }

    @Override
    public int[] attributeRead(Expression.AttributeRead read) {
        if (read.object().type() instanceof Type.ClassType type) {
            return values.part(bits(read.object()), type, read.index());
        }
        throw noBits(read);
    }

    @Override
    public int[] portMatches(Expression.PortMatches matches) {
        Expression read = new Expression.PortRead(matches.port(), matches.span());
        int has = reads.has(matches.port());
        return one(
                matches.pattern()
                        .match(
                                oneOf -> circuit.and(has, isIn(read, oneOf.values())),
                                () -> -has,
                                () -> has));
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

    /** As models compare; see {@link #areSame}. */
    int areEqual(Expression one, Expression other) {
        return reals(one, other)
                .map(reals -> reals.areEqual(bits(one), bits(other)))
                .orElseGet(() -> areSame(one, other));
    }

    /**
     * Whether they are the same message: two zeros are two messages, and what is no number is one.
     */
    int areSame(Expression one, Expression other) {
        requireAlike(one.type(), other);
        int[] a = bits(one);
        int[] b = bits(other);
        int width = Math.max(a.length, b.length);
        return circuit.areEqual(Circuit.resized(a, width), Circuit.resized(b, width));
    }

    /**
     * That codes of an expression can be compared with those of a type.
     *
     * @throws GivenUp where they cannot
     */
    static void requireAlike(Type type, Expression other) {
        boolean alike =
                type.equals(other.type())
                        || Interval.isInteger(type) && Interval.isInteger(other.type())
                        || type instanceof Type.EnumType && other.type() instanceof Type.EnumType;
        if (!alike) {
            throw noBits(other);
        }
    }

    private static boolean isNoNumber(Type type) {
        return type instanceof Type.StringType || type instanceof Type.ClassType;
    }

    /** Whether all of its bits are needed as they are. */
    private static boolean isWhole(Type type) {
        return type instanceof Type.RealType || isNoNumber(type);
    }

    @Override
    public int[] conditional(Expression.Conditional choice) {
        return circuit.choose(
                truth(choice.condition()),
                sized(choice.then(), choice.type()),
                sized(choice.otherwise(), choice.type()));
    }

    @Override
    public int[] cast(Expression.Cast cast) {
        if (isNoNumber(cast.type()) || isNoNumber(cast.operand().type())) {
            throw noBits(cast);
        }
        if (cast.type() instanceof Type.RealType real) {
            return toReal(cast.operand(), real);
        }
        if (cast.operand().type() instanceof Type.RealType real) {
            int width = Math.max(Integer.SIZE, values.width(cast.type()));
            return narrowed(values.reals(real).toWhole(bits(cast.operand()), width), cast.type());
        }
        return narrowed(bits(cast.operand()), cast.type());
    }

    private int[] toReal(Expression operand, Type.RealType type) {
        if (operand.type() instanceof Type.RealType from) {
            return from.equals(type)
                    ? bits(operand)
                    : values.reals(type).converted(bits(operand), RealFormat.of(from));
        }
        if (!operand.type().isNumber()) {
            throw noBits(operand);
        }
        return values.reals(type).ofWhole(bits(operand));
    }

    private int[] narrowed(int[] operand, Type type) {
        if (type instanceof Type.CharacterType) {
            int[] wide = Circuit.resized(operand, Integer.SIZE);
            for (int i = Character.SIZE; i < wide.length; i++) {
                wide[i] = circuit.of(false);
            }
            return wide;
        }
        if (type instanceof Type.IntegerType integer) {
            int kept =
                    switch (integer.width()) {
                        case BYTE -> Byte.SIZE;
                        case SHORT -> Short.SIZE;
                        case INT -> Integer.SIZE;
                        case LONG -> Long.SIZE;
                    };
            int[] narrow = Circuit.resized(operand, Math.min(kept, operand.length));
            return Circuit.resized(narrow, values.width(integer));
        }
        return Circuit.resized(operand, values.width(type));
    }

    @Override
    public int[] unary(Expression.Unary unary) {
        int[] operand = sized(unary.operand(), unary.type());
        return switch (unary.operator()) {
            case NOT -> one(-operand[0]);
            case NEGATE -> negated(operand, unary.type());
            case COMPLEMENT -> circuit.complement(operand);
        };
    }

    private int[] negated(int[] operand, Type type) {
        return type instanceof Type.RealType real
                ? values.reals(real).negated(operand)
                : circuit.negated(operand);
    }

    /** In as many bits as a type has. */
    private int[] sized(Expression operand, Type type) {
        if (!type.equals(operand.type()) && (isWhole(type) || isWhole(operand.type()))) {
            throw noBits(operand);
        }
        return Circuit.resized(bits(operand), values.width(type));
    }

    @Override
    public int[] binary(Expression.Binary binary) {
        Expression left = binary.left();
        Expression right = binary.right();
        return switch (binary.operator()) {
            case EQUAL -> one(areEqual(left, right));
            case NOT_EQUAL -> one(-areEqual(left, right));
            case LESS -> one(isLess(left, right));
            case LESS_OR_EQUAL -> one(isAtMost(left, right));
            case GREATER -> one(isLess(right, left));
            case GREATER_OR_EQUAL -> one(isAtMost(right, left));
            case AND -> one(circuit.and(truth(left), truth(right)));
            case OR -> one(circuit.or(truth(left), truth(right)));
            case IMPLIES -> one(circuit.or(-truth(left), truth(right)));
            case EQUIVALENT -> one(-circuit.xor(truth(left), truth(right)));
            default -> arithmetic(binary);
        };
    }

    private int isLess(Expression one, Expression other) {
        return reals(one, other)
                .map(reals -> reals.isLess(bits(one), bits(other)))
                .orElseGet(() -> isBelow(one, other));
    }

    /** What is no number is neither. */
    private int isAtMost(Expression one, Expression other) {
        return reals(one, other)
                .map(reals -> reals.isAtMost(bits(one), bits(other)))
                .orElseGet(() -> -isBelow(other, one));
    }

    private int isBelow(Expression one, Expression other) {
        if (isNoNumber(one.type()) || isNoNumber(other.type())) {
            throw noBits(one);
        }
        int[] a = bits(one);
        int[] b = bits(other);
        int width = Math.max(a.length, b.length);
        return circuit.isLess(Circuit.resized(a, width), Circuit.resized(b, width));
    }

    private int[] arithmetic(Expression.Binary binary) {
        if (UnknownResults.isOf(binary)) {
            return unknown.bits(
                    binary,
                    bits(binary.left()),
                    bits(binary.right()),
                    () -> values.some(binary.type()));
        }
        if (isNoNumber(binary.type())) {
            throw noBits(binary);
        }
        int[] left = sized(binary.left(), binary.type());
        int[] right = sized(binary.right(), binary.type());
        return binary.type() instanceof Type.RealType real
                ? calculated(values.reals(real), binary.operator(), left, right)
                : calculated(binary.operator(), left, right);
    }

    private int[] calculated(BinaryOperator operator, int[] left, int[] right) {
        return switch (operator) {
            case PLUS -> circuit.sum(left, right);
            case MINUS -> circuit.difference(left, right);
            case MULTIPLY -> circuit.product(left, right);
            case DIVIDE -> circuit.divided(left, right).quotient();
            case REMAINDER -> circuit.divided(left, right).rest();
            default -> throw new AssertionError(operator);
        };
    }

    private static int[] calculated(
            FloatingPoint reals, BinaryOperator operator, int[] left, int[] right) {
        return switch (operator) {
            case PLUS -> reals.sum(left, right);
            case MINUS -> reals.difference(left, right);
            case MULTIPLY -> reals.product(left, right);
            case DIVIDE -> reals.quotient(left, right);
            default -> throw new AssertionError(operator);
        };
    }
}
