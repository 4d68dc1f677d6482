package arcomat.semantics.expression;

import arcomat.model.Expression;

import java.util.IdentityHashMap;
import java.util.Map;

/**
 * How many parts the two-valued conditions of an expression have, as {@link Guards} makes them for
 * people to read: where connectives are compared, and where conditionals decide, both truth values
 * of what nests are asked for, and that doubles with each level.
 *
 * @param truth that it is true
 * @param defined that it has a value
 * @param value which one
 */
record ConditionLength(long truth, long defined, long value) {
    private static final long MOST = Integer.MAX_VALUE;

    static ConditionLength of(Expression e, Formulas formulas) {
        return of(e, formulas, new IdentityHashMap<>());
    }

    private static ConditionLength of(
            Expression e, Formulas formulas, Map<Expression, ConditionLength> known) {
        ConditionLength length = known.get(e);
        if (length == null) {
            length = formulas.isStrict(e) ? strict(e) : computed(e, formulas, known);
            known.put(e, length);
        }
        return length;
    }

    private static ConditionLength strict(Expression e) {
        long parts = parts(e);
        return new ConditionLength(parts, 1, parts);
    }

    /** How many parts an expression has as it is written. */
    static long parts(Expression e) {
        long[] parts = {0};
        e.visit(each -> parts[0]++);
        return parts[0];
    }

    private static ConditionLength computed(
            Expression e, Formulas formulas, Map<Expression, ConditionLength> known) {
        long truth = 1;
        long defined = 1;
        long value = 1;
        for (Expression operand : e.operands()) {
            ConditionLength part = of(operand, formulas, known);
            truth = sum(truth, part.truth);
            defined = sum(defined, part.defined);
            value = sum(value, part.value);
        }
        if (e instanceof Expression.Conditional choice) {
            long condition = of(choice.condition(), formulas, known).truth;
            truth = sum(truth, condition);
            defined = sum(defined, sum(condition, condition));
            value = sum(value, condition);
        } else if (Formulas.isLazy(e)) {
            defined = sum(truth, truth);
            value = truth;
        } else if (!Formulas.isNegation(e)) {
            truth = sum(defined, value);
        }
        return new ConditionLength(truth, defined, value);
    }

    private static long sum(long one, long another) {
        return Math.min(MOST, one + another);
    }
}
