package arcomat.semantics.expression;

import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Value;

import java.math.BigInteger;
import java.util.List;
import java.util.function.Function;

/**
 * Between which numbers an integer lies, as far as the types of what is read tell. What does not
 * fit the width of its type wraps around, and then lies anywhere in it.
 */
public record Interval(BigInteger low, BigInteger high) {

    /** Whether a result itself may have to wrap around. */
    public static boolean wraps(Expression e) {
        return !unwrapped(e).isWithin(ofWidth(e.type()));
    }

    /** Whether an expression makes an integer of other numbers. */
    public static boolean computes(Expression e) {
        return isInteger(e.type())
                && !e.operands().isEmpty()
                && !(e instanceof Expression.Conditional || e instanceof Expression.AttributeRead);
    }

    /** Characters count as their codes. */
    public static boolean isInteger(Type type) {
        return type instanceof Type.IntegerType || type instanceof Type.CharacterType;
    }

    /** Of the value of an expression. */
    public static Interval of(Expression e) {
        return of(e, Interval::ofType);
    }

    /**
     * Of the value of an expression, for who knows more or less than the types tell.
     *
     * @param read where what is read lies
     */
    public static Interval of(Expression e, Function<Expression, Interval> read) {
        if (e instanceof Expression.Conditional choice) {
            return of(choice.then(), read).and(of(choice.otherwise(), read));
        }
        Interval result = unwrapped(e, read);
        return computes(e) && !result.isWithin(ofWidth(e.type())) ? ofWidth(e.type()) : result;
    }

    /**
     * Whether a value is in the range of what it is for, whatever is read. A message keeps its
     * range; but nothing is concluded of what others may have sent.
     *
     * @param variables where what is read of a variable lies
     */
    public static boolean fits(
            Expression value, Type wanted, Function<Expression.VariableRead, Interval> variables) {
        if (!(wanted instanceof Type.IntegerType range) || !range.ranged()) {
            return true;
        }
        Interval possible =
                value instanceof Expression.PortRead
                        ? ofType(value)
                        : of(value, e -> ofReading(e, variables));
        return possible.isWithin(of(range.low(), range.high()));
    }

    private static Interval ofReading(
            Expression e, Function<Expression.VariableRead, Interval> variables) {
        if (e instanceof Expression.VariableRead read) {
            return variables.apply(read);
        }
        return e instanceof Expression.ParameterRead ? ofType(e) : ofWidth(e.type());
    }

    /** Of what is computed of the values of the operands, before it is made to fit. */
    public static Interval unwrapped(Expression e) {
        return unwrapped(e, Interval::ofType);
    }

    private static Interval unwrapped(Expression e, Function<Expression, Interval> read) {
        return e.match(new Unwrapped(read));
    }

    private record Unwrapped(Function<Expression, Interval> read)
            implements Expression.SomeCases<Interval> {
        @Override
        public Interval constant(Expression.Constant constant) {
            return ofConstant(constant);
        }

        @Override
        public Interval cast(Expression.Cast cast) {
            return isInteger(cast.operand().type()) ? of(cast.operand(), read) : read.apply(cast);
        }

        @Override
        public Interval unary(Expression.Unary unary) {
            Interval operand = of(unary.operand(), read);
            Interval negated = new Interval(operand.high.negate(), operand.low.negate());
            return unary.operator() == Expression.UnaryOperator.NEGATE
                    ? negated
                    : negated.plus(ofConstant(-1));
        }

        @Override
        public Interval binary(Expression.Binary binary) {
            return ofResult(binary, of(binary.left(), read), of(binary.right(), read));
        }

        @Override
        public Interval otherwise(Expression e) {
            return read.apply(e);
        }
    }

    /** Of what may be read, by its type. */
    public static Interval ofType(Expression e) {
        return ofType(e.type());
    }

    private static Interval ofConstant(Expression.Constant constant) {
        if (constant.value() instanceof Value.IntegerValue number) {
            return ofConstant(number.value());
        }
        return constant.value() instanceof Value.CharacterValue character
                ? ofConstant(character.value())
                : ofType(constant.type());
    }

    private static Interval ofConstant(long number) {
        return new Interval(BigInteger.valueOf(number), BigInteger.valueOf(number));
    }

    private static Interval ofType(Type type) {
        return type instanceof Type.IntegerType integer
                ? of(integer.low(), integer.high())
                : ofWidth(type);
    }

    /** All that a type can hold; a range does not narrow it. */
    public static Interval ofWidth(Type type) {
        if (type instanceof Type.CharacterType) {
            return of(Character.MIN_VALUE, Character.MAX_VALUE);
        }
        Type.Width width =
                type instanceof Type.IntegerType integer ? integer.width() : Type.Width.INT;
        Type.IntegerType whole = Type.IntegerType.of(width);
        return of(whole.low(), whole.high());
    }

    public static Interval of(long low, long high) {
        return new Interval(BigInteger.valueOf(low), BigInteger.valueOf(high));
    }

    private static Interval ofResult(Expression.Binary binary, Interval left, Interval right) {
        return switch (binary.operator()) {
            case PLUS -> left.plus(right);
            case MINUS -> left.plus(new Interval(right.high.negate(), right.low.negate()));
            case MULTIPLY ->
                    spanning(
                            left.low.multiply(right.low),
                            left.low.multiply(right.high),
                            left.high.multiply(right.low),
                            left.high.multiply(right.high));
            case DIVIDE ->
                    right.low.signum() < 0
                            ? spanning(left.low, left.high, left.low.negate(), left.high.negate())
                            : spanning(left.low, left.high, BigInteger.ZERO);
            case REMAINDER -> left.remainder(right);
            default -> ofType(binary.type());
        };
    }

    /** Nearer to 0 than the divisor, and on the side of the dividend, which it never exceeds. */
    private Interval remainder(Interval divisor) {
        BigInteger most =
                divisor.low
                        .abs()
                        .max(divisor.high.abs())
                        .subtract(BigInteger.ONE)
                        .max(BigInteger.ZERO);
        return new Interval(
                low.min(BigInteger.ZERO).max(most.negate()), high.max(BigInteger.ZERO).min(most));
    }

    private static Interval spanning(BigInteger... ends) {
        List<BigInteger> all = List.of(ends);
        return new Interval(
                all.stream().reduce(BigInteger::min).orElseThrow(),
                all.stream().reduce(BigInteger::max).orElseThrow());
    }

    private Interval plus(Interval other) {
        return new Interval(low.add(other.low), high.add(other.high));
    }

    private Interval and(Interval other) {
        return spanning(low, high, other.low, other.high);
    }

    public boolean isWithin(Interval other) {
        return other.low.compareTo(low) <= 0 && high.compareTo(other.high) <= 0;
    }

    /** What lies in both, or this where that is nothing. */
    public Interval within(Interval other) {
        Interval both = new Interval(low.max(other.low), high.min(other.high));
        return both.low.compareTo(both.high) <= 0 ? both : this;
    }

    /** How many numbers there are. */
    public BigInteger size() {
        return high.subtract(low).add(BigInteger.ONE);
    }

    /** How often a number is beyond the end of this interval; negative below its beginning. */
    public BigInteger turns(BigInteger number) {
        BigInteger[] parts = number.subtract(low).divideAndRemainder(size());
        return parts[1].signum() < 0 ? parts[0].subtract(BigInteger.ONE) : parts[0];
    }
}
