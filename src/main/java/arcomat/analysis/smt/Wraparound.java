package arcomat.analysis.smt;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Expression.UnaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Interval;
import arcomat.semantics.expression.Rewriting;

import java.util.ArrayList;
import java.util.List;

/**
 * When the evaluation of an expression meets an integer that does not fit its type and wraps
 * around; said as an expression itself, which the interpreter can try and the solver can solve.
 * Connectives are evaluated from the left, and only as far as needed.
 */
final class Wraparound {
    private static final Type TRUTH = new Type.BooleanType();

    /** It never does. */
    static final Expression NEVER =
            new Expression.Constant(new Value.BooleanValue(false), TRUTH, null);

    private static final Type LONG = Type.IntegerType.of(Type.Width.LONG);

    private Wraparound() {}

    static Expression in(Expression e) {
        if (e instanceof Expression.Binary binary && isLazy(binary.operator())) {
            Expression left = binary.left();
            Expression goesOn = binary.operator() == BinaryOperator.OR ? not(left) : left;
            return or(in(left), and(goesOn, in(binary.right())));
        }
        if (e instanceof Expression.Conditional choice) {
            Expression then = in(choice.then());
            Expression otherwise = in(choice.otherwise());
            Expression branch =
                    isNever(then) && isNever(otherwise)
                            ? then
                            : new Expression.Conditional(
                                    choice.condition(), then, otherwise, TRUTH, e.span());
            return or(in(choice.condition()), branch);
        }
        if (e instanceof Expression.PortMatches matches) {
            return in(matches);
        }
        Expression any = NEVER;
        for (Expression operand : Rewriting.operands(e)) {
            any = or(any, in(operand));
        }
        return or(any, here(e));
    }

    /** Nothing is computed where there is no message, and nothing behind a value that fits. */
    private static Expression in(Expression.PortMatches matches) {
        List<Expression> values = new ArrayList<>(Rewriting.operands(matches));
        Expression any = NEVER;
        for (int i = values.size() - 1; i >= 0; i--) {
            Expression fits =
                    new Expression.PortMatches(
                            matches.port(),
                            new Automaton.OneOf(List.of(values.get(i))),
                            matches.span());
            any = or(in(values.get(i)), and(not(fits), any));
        }
        Expression present =
                new Expression.PortMatches(matches.port(), new Automaton.Present(), matches.span());
        return and(present, any);
    }

    static boolean isLazy(BinaryOperator operator) {
        return operator == BinaryOperator.AND
                || operator == BinaryOperator.OR
                || operator == BinaryOperator.IMPLIES;
    }

    /** At the operation itself. */
    private static Expression here(Expression e) {
        if (!Interval.computes(e) || !Interval.wraps(e)) {
            return NEVER;
        }
        if (e instanceof Expression.Cast cast) {
            return not(equal(wide(cast), wide(cast.operand())));
        }
        if (e instanceof Expression.Unary unary) {
            return equal(unary.operand(), least(unary.operand().type()));
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
        return new Expression.Conditional(
                grows,
                compare(BinaryOperator.LESS, e, left),
                compare(BinaryOperator.GREATER, e, left),
                TRUTH,
                e.span());
    }

    private static Expression isLeastByMinusOne(Expression left, Expression right) {
        return and(equal(left, least(left.type())), equal(right, number(-1, right)));
    }

    private static boolean isLong(Type type) {
        return type instanceof Type.IntegerType integer && integer.width() == Type.Width.LONG;
    }

    private static Expression least(Type type) {
        long low = Interval.ofWidth(type).low().longValueExact();
        return new Expression.Constant(new Value.IntegerValue(low), type, null);
    }

    private static Expression number(long number, Expression like) {
        return new Expression.Constant(new Value.IntegerValue(number), like.type(), like.span());
    }

    private static Expression wide(Expression e) {
        return new Expression.Cast(e, LONG, e.span());
    }

    private static Expression equal(Expression left, Expression right) {
        return compare(BinaryOperator.EQUAL, left, right);
    }

    private static Expression compare(BinaryOperator operator, Expression left, Expression right) {
        return new Expression.Binary(operator, left, right, TRUTH, left.span());
    }

    static boolean isNever(Expression condition) {
        return condition == NEVER;
    }

    private static Expression not(Expression e) {
        return new Expression.Unary(UnaryOperator.NOT, e, TRUTH, e.span());
    }

    private static Expression and(Expression left, Expression right) {
        return isNever(right)
                ? right
                : new Expression.Binary(BinaryOperator.AND, left, right, TRUTH, left.span());
    }

    static Expression or(Expression left, Expression right) {
        if (isNever(left) || isNever(right)) {
            return isNever(left) ? right : left;
        }
        return new Expression.Binary(BinaryOperator.OR, left, right, TRUTH, left.span());
    }
}
