package arcomat.semantics.expression;

import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Valuation;

import java.util.ArrayList;
import java.util.List;

/**
 * How conditions are judged. What is no connective, and compares no truth values, is a part; so is
 * what reads only messages that are there together. A conditional that one side of a comparison
 * depends on decides between two comparisons.
 */
record Judging(Formulas formulas, TwoValued conditions) implements Expression.SomeCases<Valuation> {
    Valuation of(Expression e) {
        return formulas.isStrict(e)
                ? new Valuation.Part(formulas.present(e), Formulas.folded(e))
                : e.match(this);
    }

    @Override
    public Valuation unary(Expression.Unary unary) {
        return Formulas.isNegation(unary)
                ? new Valuation.Not(of(unary.operand()))
                : compared(unary);
    }

    @Override
    public Valuation conditional(Expression.Conditional choice) {
        return new Valuation.Choice(
                of(choice.condition()), of(choice.then()), of(choice.otherwise()));
    }

    @Override
    public Valuation binary(Expression.Binary binary) {
        return binary.left().type() instanceof Type.BooleanType ? joined(binary) : compared(binary);
    }

    @Override
    public Valuation portMatches(Expression.PortMatches matches) {
        return part(matches);
    }

    @Override
    public Valuation otherwise(Expression e) {
        return compared(e);
    }

    private Valuation part(Expression e) {
        return new Valuation.Part(formulas.simplify(conditions.defined(e)), conditions.value(e));
    }

    private Valuation joined(Expression.Binary binary) {
        Valuation left = of(binary.left());
        Valuation right = of(binary.right());
        return switch (binary.operator()) {
            case AND -> new Valuation.Row(true, left, right);
            case OR -> new Valuation.Row(false, left, right);
            case IMPLIES -> new Valuation.Row(false, new Valuation.Not(left), right);
            case NOT_EQUAL -> new Valuation.Comparison(false, left, right);
            default -> new Valuation.Comparison(true, left, right);
        };
    }

    /** A conditional decides after it has been asked whether what stands before it is there. */
    private Valuation compared(Expression comparison) {
        List<Expression> open = new ArrayList<>();
        List<Expression> before = new ArrayList<>();
        addOpen(comparison, open, before);
        if (open.size() != 1 || !(open.get(0) instanceof Expression.Conditional choice)) {
            return part(comparison);
        }
        Valuation decided =
                new Valuation.Choice(
                        of(choice.condition()),
                        of(replaced(comparison, choice, choice.then())),
                        of(replaced(comparison, choice, choice.otherwise())));
        Expression there =
                before.stream().map(formulas::present).reduce(Formulas.TRUE, Formulas::and);
        return there.equals(Formulas.TRUE)
                ? decided
                : new Valuation.Choice(
                        new Valuation.Part(there, Formulas.TRUE),
                        decided,
                        new Valuation.Part(Formulas.TRUE, Formulas.FALSE));
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
