package arcomat.semantics.expression;

import arcomat.model.Expression;
import arcomat.model.Judgement;
import arcomat.model.Type;

import java.util.ArrayList;
import java.util.List;

/**
 * How conditions are judged. What is no connective, and compares no truth values, is a part; so is
 * what reads only messages that are there together. A conditional that one side of a comparison
 * depends on decides between two comparisons.
 */
record Judging(Formulas formulas, TwoValued conditions) {
    Judgement of(Expression e) {
        if (formulas.isStrict(e)) {
            return new Judgement.Part(formulas.present(e), Formulas.folded(e));
        }
        if (Formulas.isNegation(e)) {
            return new Judgement.Not(of(e.operands().get(0)));
        }
        if (e instanceof Expression.Conditional choice) {
            return new Judgement.Choice(
                    of(choice.condition()), of(choice.then()), of(choice.otherwise()));
        }
        if (e instanceof Expression.Binary binary
                && binary.left().type() instanceof Type.BooleanType) {
            return joined(binary);
        }
        return e instanceof Expression.PortMatches ? part(e) : compared(e);
    }

    private Judgement part(Expression e) {
        return new Judgement.Part(formulas.simplify(conditions.defined(e)), conditions.value(e));
    }

    private Judgement joined(Expression.Binary binary) {
        Judgement left = of(binary.left());
        Judgement right = of(binary.right());
        return switch (binary.operator()) {
            case AND -> new Judgement.Row(true, left, right);
            case OR -> new Judgement.Row(false, left, right);
            case IMPLIES -> new Judgement.Row(false, new Judgement.Not(left), right);
            case NOT_EQUAL -> new Judgement.Comparison(false, left, right);
            default -> new Judgement.Comparison(true, left, right);
        };
    }

    /** A conditional decides after it has been asked whether what stands before it is there. */
    private Judgement compared(Expression comparison) {
        List<Expression> open = new ArrayList<>();
        List<Expression> before = new ArrayList<>();
        addOpen(comparison, open, before);
        if (open.size() != 1 || !(open.get(0) instanceof Expression.Conditional choice)) {
            return part(comparison);
        }
        Judgement decided =
                new Judgement.Choice(
                        of(choice.condition()),
                        of(replaced(comparison, choice, choice.then())),
                        of(replaced(comparison, choice, choice.otherwise())));
        Expression there =
                before.stream().map(formulas::present).reduce(Formulas.TRUE, Formulas::and);
        return there.equals(Formulas.TRUE)
                ? decided
                : new Judgement.Choice(
                        new Judgement.Part(there, Formulas.TRUE),
                        decided,
                        new Judgement.Part(Formulas.TRUE, Formulas.FALSE));
    }

    /**
     * Adds the operands that may be undefined although all messages are there.
     *
     * @param before what stands before the first one of them
     */
    private void addOpen(Expression e, List<Expression> open, List<Expression> before) {
        for (Expression operand : e.operands()) {
            if (!formulas.isStrict(operand)) {
                if (operand.type().isNumber() && !(operand instanceof Expression.Conditional)) {
                    addOpen(operand, open, before);
                } else {
                    open.add(operand);
                }
            } else if (open.isEmpty()) {
                before.add(operand);
            }
        }
    }

    private static Expression replaced(Expression e, Expression part, Expression by) {
        return e == part ? by : e.withOperands(operand -> replaced(operand, part, by));
    }
}
