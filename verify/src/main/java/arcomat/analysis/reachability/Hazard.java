package arcomat.analysis.reachability;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Interval;

import java.util.List;
import java.util.function.UnaryOperator;

/**
 * When the evaluation of an expression meets something that an operation may do, the negation of a
 * condition of well-definedness; said as an expression itself, which the interpreter can try and
 * the solver can solve. Connectives are evaluated from the left, and only as far as needed.
 *
 * @param here whether an operation itself does it, where its operands do not
 */
public record Hazard(UnaryOperator<Expression> here) implements Expression.Cases<Expression> {
    private static final Type TRUTH = new Type.BooleanType();

    /** It never does. */
    @SuppressWarnings("NullAway") // it stands nowhere
    public static final Expression NEVER =
            new Expression.Constant(new Value.BooleanValue(false), TRUTH, null);

    /** A divisor is zero. */
    static final Hazard DIVISION_BY_ZERO = new Hazard(Hazard::hasNoQuotient);

    Expression inAny(List<Expression> expressions) {
        return expressions.stream().map(this::in).reduce(NEVER, Hazard::or);
    }

    Expression in(Expression e) {
        return e.match(this);
    }

    @Override
    public Expression binary(Expression.Binary binary) {
        if (!binary.operator().isLazy()) {
            return inAll(binary);
        }
        Expression left = binary.left();
        Expression goesOn = binary.operator() == BinaryOperator.OR ? not(left) : left;
        return or(in(left), and(goesOn, in(binary.right())));
    }

    @Override
    public Expression conditional(Expression.Conditional choice) {
        Expression then = in(choice.then());
        Expression otherwise = in(choice.otherwise());
        Expression branch =
                isNever(then) && isNever(otherwise)
                        ? then
                        : choose(choice.condition(), then, otherwise);
        return or(in(choice.condition()), branch);
    }

    /** Nothing is computed where there is no message, and nothing behind a value that fits. */
    @Override
    public Expression portMatches(Expression.PortMatches matches) {
        Expression present =
                new Expression.PortMatches(matches.port(), new Automaton.Present(), matches.span());
        return and(
                present,
                inFirst(
                        matches.operands(),
                        value ->
                                new Expression.PortMatches(
                                        matches.port(),
                                        new Automaton.OneOf(List.of(value)),
                                        matches.span())));
    }

    /** Nothing is computed behind a value that is the element. */
    @Override
    public Expression isIn(Expression.IsIn isIn) {
        Expression element = isIn.element();
        return or(
                in(element),
                inFirst(isIn.set(), value -> compare(BinaryOperator.EQUAL, element, value)));
    }

    /**
     * In one of some values, up to the first that fits.
     *
     * @param fits whether a value does
     */
    private Expression inFirst(List<Expression> values, UnaryOperator<Expression> fits) {
        Expression any = NEVER;
        for (int i = values.size() - 1; i >= 0; i--) {
            Expression value = values.get(i);
            any = or(in(value), isNever(any) ? any : and(not(fits.apply(value)), any));
        }
        return any;
    }

    @Override
    public Expression constant(Expression.Constant constant) {
        return inAll(constant);
    }

    @Override
    public Expression portRead(Expression.PortRead portRead) {
        return inAll(portRead);
    }

    @Override
    public Expression variableRead(Expression.VariableRead variableRead) {
        return inAll(variableRead);
    }

    @Override
    public Expression parameterRead(Expression.ParameterRead parameterRead) {
        return inAll(parameterRead);
    }

    @Override
    public Expression attributeRead(Expression.AttributeRead attributeRead) {
        return inAll(attributeRead);
    }

    @Override
    public Expression unary(Expression.Unary unary) {
        return inAll(unary);
    }

    @Override
    public Expression cast(Expression.Cast cast) {
        return inAll(cast);
    }

    /** Only what runs is judged. */
    @Override
    public Expression judged(Expression.Judged judged) {
        throw new AssertionError(judged);
    }

    /** All operands are evaluated, and then it itself. */
    private Expression inAll(Expression e) {
        return or(inAny(e.operands()), here.apply(e));
    }

    /** A value is none of a type with a range. */
    public static Expression outside(Expression value, Type type) {
        if (!(type instanceof Type.IntegerType integer) || !integer.ranged()) {
            return NEVER;
        }
        Expression wide =
                new Expression.Cast(value, Type.IntegerType.of(Type.Width.LONG), value.span());
        return or(
                compare(BinaryOperator.LESS, wide, number(integer.low(), wide)),
                compare(BinaryOperator.GREATER, wide, number(integer.high(), wide)));
    }

    private static Expression hasNoQuotient(Expression e) {
        boolean divides =
                e instanceof Expression.Binary binary
                        && binary.operator().divides()
                        && Interval.isInteger(binary.type());
        if (!divides) {
            return NEVER;
        }
        Expression divisor = ((Expression.Binary) e).right();
        return compare(BinaryOperator.EQUAL, divisor, number(0, divisor));
    }

    public static boolean isNever(Expression condition) {
        return condition == NEVER;
    }

    /** A number of the type of an expression, at its place. */
    public static Expression number(long number, Expression like) {
        return new Expression.Constant(new Value.IntegerValue(number), like.type(), like.span());
    }

    public static Expression compare(BinaryOperator operator, Expression left, Expression right) {
        return new Expression.Binary(operator, left, right, TRUTH, left.span());
    }

    static Expression choose(Expression condition, Expression then, Expression otherwise) {
        return new Expression.Conditional(condition, then, otherwise, TRUTH, condition.span());
    }

    public static Expression not(Expression e) {
        return new Expression.Unary(Expression.UnaryOperator.NOT, e, TRUTH, e.span());
    }

    public static Expression and(Expression left, Expression right) {
        return isNever(right) ? right : compare(BinaryOperator.AND, left, right);
    }

    public static Expression or(Expression left, Expression right) {
        if (isNever(left) || isNever(right)) {
            return isNever(left) ? right : left;
        }
        return compare(BinaryOperator.OR, left, right);
    }
}
