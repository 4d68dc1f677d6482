package arcomat.semantics.expression;

import static arcomat.semantics.expression.Formulas.and;
import static arcomat.semantics.expression.Formulas.not;
import static arcomat.semantics.expression.Formulas.or;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;

import java.util.List;

/**
 * Two-valued conditions of expressions that may be undefined. As a person writes them, both truth
 * values of each part are asked for where connectives are compared and where conditionals decide,
 * and a condition doubles with each level of such a nest. Asked once, whether a part has a value
 * and which one are asked apart, and where one operand does not nest, the other one is looked at
 * once by each: a condition grows with the square of the depth.
 *
 * @param once whether what nests, and cannot go wrong, is asked for once
 */
record TwoValued(Formulas formulas, boolean once) {
    /** That an expression has a value, and this one. */
    Expression certainly(boolean truth, Expression e) {
        if (e instanceof Expression.PortMatches matches) {
            return truth ? of(matches) : not(of(matches));
        }
        if (formulas.isStrict(e)) {
            return and(formulas.present(e), truth ? Formulas.folded(e) : not(e));
        }
        if (Formulas.isNegation(e)) {
            return certainly(!truth, e.operands().get(0));
        }
        if (e instanceof Expression.Conditional choice) {
            return chosen(
                    choice, certainly(truth, choice.then()), certainly(truth, choice.otherwise()));
        }
        if (Formulas.isLazy(e)) {
            Connective both = Connective.of((Expression.Binary) e);
            return both.joined(truth, certainly(truth, both.left), certainly(truth, both.right));
        }
        return and(defined(e), truth ? value(e) : not(value(e)));
    }

    /** What may go wrong is looked at as often, and in the order, that its meaning says. */
    private boolean isAskedOnce(Expression e) {
        return once && !e.divides();
    }

    /**
     * One of two conditions, as the condition of a conditional decides, if it has a value. Of one
     * that may go wrong it is not asked once more, where it is true, whether it is false.
     */
    private Expression chosen(
            Expression.Conditional choice, Expression then, Expression otherwise) {
        Expression condition = choice.condition();
        if (!formulas.isStrict(condition) && (once || condition.divides())) {
            Expression decides = value(condition);
            return and(
                    defined(condition),
                    new Expression.Conditional(
                            decides, then, otherwise, new Type.BooleanType(), condition.span()));
        }
        return or(
                and(certainly(true, condition), then), and(certainly(false, condition), otherwise));
    }

    /** When an expression of any type has a value. */
    Expression defined(Expression e) {
        if (formulas.isStrict(e)) {
            return formulas.present(e);
        }
        if (e instanceof Expression.PortMatches) {
            return Formulas.TRUE;
        }
        if (e instanceof Expression.Conditional choice) {
            return chosen(choice, defined(choice.then()), defined(choice.otherwise()));
        }
        if (Formulas.isLazy(e) && !isAskedOnce(e)) {
            return or(certainly(true, e), certainly(false, e));
        }
        if (Formulas.isLazy(e) && !Formulas.isNegation(e)) {
            return defined(Connective.of((Expression.Binary) e), e);
        }
        return e.operands().stream().map(this::defined).reduce(Formulas.TRUE, Formulas::and);
    }

    /** An operand decides, or both have a value: what nests is asked for once. */
    private Expression defined(Connective both, Expression e) {
        boolean decides = !both.all;
        if (formulas.isStrict(both.left)) {
            return or(
                    certainly(decides, both.left),
                    and(
                            defined(both.right),
                            or(formulas.present(both.left), is(decides, both.right))));
        }
        return formulas.isStrict(both.right)
                ? or(
                        and(
                                defined(both.left),
                                or(is(decides, both.left), formulas.present(both.right))),
                        certainly(decides, both.right))
                : or(certainly(true, e), certainly(false, e));
    }

    private Expression is(boolean truth, Expression e) {
        return truth ? value(e) : not(value(e));
    }

    /** Agrees with the expression where that is defined; harmless, but anything, elsewhere. */
    Expression value(Expression e) {
        if (formulas.isStrict(e)) {
            return e;
        }
        if (e instanceof Expression.PortMatches matches) {
            return of(matches);
        }
        if (Formulas.isLazy(e) && !isAskedOnce(e)) {
            return certainly(true, e);
        }
        if (e instanceof Expression.Conditional choice && !isAskedOnce(e)) {
            return new Expression.Conditional(
                    certainly(true, choice.condition()),
                    value(choice.then()),
                    value(choice.otherwise()),
                    choice.type(),
                    choice.span());
        }
        if (Formulas.isNegation(e) && isAskedOnce(e)) {
            return not(value(e.operands().get(0)));
        }
        return Formulas.isLazy(e)
                ? value(Connective.of((Expression.Binary) e), e)
                : e.withOperands(this::value);
    }

    /** Where one operand has no value, the other one decides. */
    private Expression value(Connective both, Expression e) {
        if (formulas.isStrict(both.left)) {
            return both.joined(true, certainly(true, both.left), value(both.right));
        }
        if (!formulas.isStrict(both.right)) {
            return certainly(true, e);
        }
        return both.all
                ? and(not(certainly(false, both.right)), value(both.left))
                : or(certainly(true, both.right), value(both.left));
    }

    /** Values of a pattern that read an absent port match nothing. */
    private Expression of(Expression.PortMatches matches) {
        if (!(matches.pattern() instanceof Automaton.OneOf oneOf)
                || formulas.present(matches).equals(Formulas.TRUE)) {
            return matches;
        }
        Expression any = Formulas.FALSE;
        for (Expression value : oneOf.values()) {
            Expression test =
                    new Expression.PortMatches(
                            matches.port(), new Automaton.OneOf(List.of(value)), matches.span());
            any = or(any, and(defined(value), test));
        }
        return any;
    }

    /**
     * Two operands of {@code &&} or {@code ||}.
     *
     * @param all whether both have to be true
     */
    private record Connective(boolean all, Expression left, Expression right) {
        static Connective of(Expression.Binary e) {
            boolean implies = e.operator() == BinaryOperator.IMPLIES;
            return new Connective(
                    e.operator() == BinaryOperator.AND,
                    implies ? not(e.left()) : e.left(),
                    e.right());
        }

        /** That this is true, or that it is false, where the same is said of the operands. */
        Expression joined(boolean truth, Expression one, Expression another) {
            return truth == all ? and(one, another) : or(one, another);
        }
    }
}
