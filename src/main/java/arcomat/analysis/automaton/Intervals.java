package arcomat.analysis.automaton;

import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.semantics.Rewriting;

import java.math.BigInteger;
import java.util.List;

/** A coarse look at integers: can the types of what it reads make an expression overflow at all? */
record Intervals(BigInteger low, BigInteger high) {

    static boolean mayOverflow(Expression e) {
        if (Rewriting.operands(e).stream().anyMatch(Intervals::mayOverflow)) {
            return true;
        }
        boolean computes =
                e instanceof Expression.Binary
                        || e instanceof Expression.Unary
                        || e instanceof Expression.Cast;
        return computes
                && e.type() instanceof Type.IntegerType integer
                && !of(e).isWithin(ofType(Type.IntegerType.of(integer.width())));
    }

    private boolean isWithin(Intervals other) {
        return other.low.compareTo(low) <= 0 && high.compareTo(other.high) <= 0;
    }

    private static Intervals ofType(Type type) {
        if (type instanceof Type.IntegerType integer) {
            return new Intervals(
                    BigInteger.valueOf(integer.low()), BigInteger.valueOf(integer.high()));
        }
        return type instanceof Type.CharacterType
                ? new Intervals(BigInteger.ZERO, BigInteger.valueOf(Character.MAX_VALUE))
                : ofType(Type.IntegerType.of(Type.Width.INT));
    }

    private static Intervals of(Expression e) {
        if (e instanceof Expression.Constant constant
                && constant.value() instanceof arcomat.model.Value.IntegerValue number) {
            BigInteger value = BigInteger.valueOf(number.value());
            return new Intervals(value, value);
        }
        if (e instanceof Expression.Cast cast
                && !(cast.operand().type() instanceof Type.RealType)) {
            return of(cast.operand());
        }
        if (e instanceof Expression.Unary unary
                && unary.operator() == Expression.UnaryOperator.NEGATE) {
            Intervals operand = of(unary.operand());
            return new Intervals(operand.high.negate(), operand.low.negate());
        }
        if (e instanceof Expression.Binary binary) {
            return of(binary, of(binary.left()), of(binary.right()));
        }
        return ofType(e.type());
    }

    private static Intervals of(Expression.Binary binary, Intervals left, Intervals right) {
        return switch (binary.operator()) {
            case PLUS -> new Intervals(left.low.add(right.low), left.high.add(right.high));
            case MINUS ->
                    new Intervals(left.low.subtract(right.high), left.high.subtract(right.low));
            case MULTIPLY ->
                    spanning(
                            left.low.multiply(right.low),
                            left.low.multiply(right.high),
                            left.high.multiply(right.low),
                            left.high.multiply(right.high));
            case DIVIDE -> spanning(left.low, left.high, left.low.negate(), left.high.negate());
            case REMAINDER -> spanning(left.low, left.high, BigInteger.ZERO);
            default -> ofType(binary.type());
        };
    }

    private static Intervals spanning(BigInteger... ends) {
        List<BigInteger> all = List.of(ends);
        return new Intervals(
                all.stream().reduce(BigInteger::min).orElseThrow(),
                all.stream().reduce(BigInteger::max).orElseThrow());
    }
}
