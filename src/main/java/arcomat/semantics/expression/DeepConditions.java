package arcomat.semantics.expression;

import static arcomat.semantics.expression.Formulas.and;
import static arcomat.semantics.expression.Formulas.not;
import static arcomat.semantics.expression.Formulas.or;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;

import java.util.function.UnaryOperator;

/**
 * Two-valued conditions for guards that nest: conditions of conditionals, and connectives that are
 * compared. What has a value and what that is are asked apart, and each looks once at what nests.
 * So a condition grows with the square of the depth; where it is asked for both truth values of
 * each part, as {@link Guards} does of others, it doubles with each level.
 *
 * @param matching two-valued, what a port is asked for
 * @param longest of how many parts other conditions may be
 */
record DeepConditions(Formulas formulas, UnaryOperator<Expression> matching, long longest) {
    /** What is longer, in parts, is made here; what is not stays as a person would write it. */
    static final long LONGEST = 5_000;

    /** Whether a guard nests so deeply. */
    boolean areFor(Expression guard) {
        return ConditionLength.of(guard, formulas).truth() > longest;
    }

    /** That an expression has a value, and this one. */
    Expression certainly(boolean truth, Expression e) {
        if (e instanceof Expression.PortMatches) {
            return truth ? matching.apply(e) : not(matching.apply(e));
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

    /** One of two conditions, as the condition of a conditional decides, if it has a value. */
    private Expression chosen(
            Expression.Conditional choice, Expression then, Expression otherwise) {
        Expression condition = choice.condition();
        return formulas.isStrict(condition)
                ? or(
                        and(certainly(true, condition), then),
                        and(certainly(false, condition), otherwise))
                : and(defined(condition), choice(value(condition), then, otherwise, condition));
    }

    static Expression choice(
            Expression condition, Expression then, Expression otherwise, Expression because) {
        return new Expression.Conditional(
                condition, then, otherwise, new Type.BooleanType(), because.span());
    }

    /** When an expression of any type has a value. */
    private Expression defined(Expression e) {
        if (formulas.isStrict(e)) {
            return formulas.present(e);
        }
        if (e instanceof Expression.PortMatches) {
            return Formulas.TRUE;
        }
        if (e instanceof Expression.Conditional choice) {
            return chosen(choice, defined(choice.then()), defined(choice.otherwise()));
        }
        if (Formulas.isLazy(e) && !Formulas.isNegation(e)) {
            return defined(Connective.of((Expression.Binary) e), e);
        }
        Expression all = Formulas.TRUE;
        for (Expression operand : e.operands()) {
            all = and(all, defined(operand));
        }
        return all;
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

    /** Agrees with the expression where that is defined, and is asked for nowhere else. */
    private Expression value(Expression e) {
        if (formulas.isStrict(e)) {
            return e;
        }
        if (e instanceof Expression.PortMatches) {
            return matching.apply(e);
        }
        if (Formulas.isNegation(e)) {
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
        if (!formulas.isStrict(both.right) || both.right.divides()) {
            return certainly(true, e);
        }
        return both.all
                ? and(not(certainly(false, both.right)), value(both.left))
                : or(certainly(true, both.right), value(both.left));
    }

    /**
     * Two operands of {@code &&} or {@code ||}.
     *
     * @param all whether both have to be true
     */
    record Connective(boolean all, Expression left, Expression right) {
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
