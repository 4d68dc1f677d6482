package arcomat.semantics.expression;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;

import java.util.ArrayList;
import java.util.List;

/** Conditions that have to be true together, one by one: a whole is true where all of them are. */
public final class Conjunction {
    private Conjunction() {}

    /**
     * What a condition consists of, in the order of the text. "Not one of both" is two as well. A
     * part that is undefined is not true, nor is the whole then.
     */
    public static List<Expression> parts(Expression condition) {
        List<Expression> parts = new ArrayList<>();
        add(condition, false, parts);
        return parts;
    }

    private static void add(Expression condition, boolean denied, List<Expression> parts) {
        if (Formulas.isNegation(condition)) {
            add(condition.operands().get(0), !denied, parts);
            return;
        }
        BinaryOperator both = denied ? BinaryOperator.OR : BinaryOperator.AND;
        if (condition instanceof Expression.Binary binary && binary.operator() == both) {
            add(binary.left(), denied, parts);
            add(binary.right(), denied, parts);
        } else {
            parts.add(denied ? Formulas.not(condition) : condition);
        }
    }
}
