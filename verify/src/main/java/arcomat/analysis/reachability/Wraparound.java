package arcomat.analysis.reachability;

import static arcomat.analysis.reachability.Hazard.and;
import static arcomat.analysis.reachability.Hazard.choose;
import static arcomat.analysis.reachability.Hazard.compare;
import static arcomat.analysis.reachability.Hazard.not;
import static arcomat.analysis.reachability.Hazard.number;
import static arcomat.analysis.reachability.Hazard.or;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.semantics.expression.Interval;

/** When an operation has a result that does not fit its type, and wraps around. */
final class Wraparound {
    static final Hazard HAZARD = new Hazard(Wraparound::here);

    private static final Type LONG = Type.IntegerType.of(Type.Width.LONG);

    private Wraparound() {}

    private static Expression here(Expression e) {
        if (!Interval.computes(e) || !Interval.wraps(e)) {
            return Hazard.NEVER;
        }
        if (e instanceof Expression.Cast cast) {
            return not(equal(wide(cast), wide(cast.operand())));
        }
        if (e instanceof Expression.Unary unary) {
            return equal(unary.operand(), least(unary.operand()));
        }
        Expression.Binary binary = (Expression.Binary) e;
        if (binary.operator() == BinaryOperator.DIVIDE) {
            return isLeastByMinusOne(binary.left(), binary.right());
        }
        if (isLong(binary.type())) {
            return inLong(binary);
        }
        Expression exact =
                new Expression.Binary(
                        binary.operator(),
                        wide(binary.left()),
                        wide(binary.right()),
                        LONG,
                        binary.span());
        return not(equal(exact, wide(binary)));
    }

    /** There is no wider type to compute it in. */
    private static Expression inLong(Expression.Binary e) {
        Expression left = e.left();
        Expression right = e.right();
        if (e.operator() == BinaryOperator.MULTIPLY) {
            Expression back =
                    new Expression.Binary(BinaryOperator.DIVIDE, e, right, LONG, e.span());
            return or(
                    or(isLeastByMinusOne(left, right), isLeastByMinusOne(right, left)),
                    and(not(equal(right, number(0, right))), not(equal(back, left))));
        }
        boolean plus = e.operator() == BinaryOperator.PLUS;
        Expression grows =
                compare(
                        plus ? BinaryOperator.GREATER_OR_EQUAL : BinaryOperator.LESS,
                        right,
                        number(0, right));
        return choose(
                grows,
                compare(BinaryOperator.LESS, e, left),
                compare(BinaryOperator.GREATER, e, left));
    }

    private static Expression isLeastByMinusOne(Expression left, Expression right) {
        return and(equal(left, least(left)), equal(right, number(-1, right)));
    }

    private static boolean isLong(Type type) {
        return type instanceof Type.IntegerType integer && integer.width() == Type.Width.LONG;
    }

    private static Expression least(Expression like) {
        return number(Interval.ofWidth(like.type()).low().longValueExact(), like);
    }

    private static Expression wide(Expression e) {
        return new Expression.Cast(e, LONG, e.span());
    }

    private static Expression equal(Expression left, Expression right) {
        return compare(BinaryOperator.EQUAL, left, right);
    }
}
