package arcomat.analysis.automaton.trap;

import arcomat.analysis.automaton.trap.EscapePlan.Step;
import arcomat.analysis.reachability.Hazard;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Variable;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.expression.Replacement;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * When plans can be carried out: weakest preconditions, by putting what is assigned and read in the
 * place of variables and messages, from the last step to the first (Dijkstra, <i>Guarded commands,
 * nondeterminacy and formal derivation of programs</i>, 1975).
 *
 * @param inputs of the component
 * @param variables of the automaton
 */
record PlanConditions(List<Port> inputs, List<Variable> variables) {
    /** Longer conditions take the solver too long. */
    private static final int MOST_PARTS = 3000;

    static PlanConditions of(Subject subject) {
        return new PlanConditions(subject.component().inputs(), subject.automaton().variables());
    }

    /**
     * What has to be so of the variables before a plan for it to be possible; empty where that
     * cannot be said, or only at length.
     *
     * @param atEnd what has to be so after the last step; of no use to a plan that escapes
     */
    Optional<Expression> of(EscapePlan plan, Expression atEnd) {
        Optional<Expression> condition = Optional.of(atEnd);
        for (int i = plan.steps().size() - 1; i >= 0; i--) {
            Step step = plan.steps().get(i);
            boolean last = i == plan.steps().size() - 1;
            condition =
                    last && plan.goal() == EscapePlan.Goal.ESCAPES
                            ? Optional.of(possible(step, step.move().escapes()))
                            : condition
                                    .flatMap(each -> before(step, each))
                                    .map(
                                            each ->
                                                    Formulas.and(
                                                            possible(step, step.move().goesOn()),
                                                            each));
            condition = condition.filter(PlanConditions::isShort);
        }
        return condition;
    }

    /** What an expression over the variables after a plan is, over those before it. */
    Optional<Expression> before(EscapePlan plan, Expression after) {
        Optional<Expression> before = Optional.of(after);
        for (int i = plan.steps().size() - 1; i >= 0; i--) {
            Step step = plan.steps().get(i);
            before = before.flatMap(each -> before(step, each)).filter(PlanConditions::isShort);
        }
        return before;
    }

    private static boolean isShort(Expression e) {
        int[] parts = {0};
        e.visit(part -> parts[0]++);
        return parts[0] <= MOST_PARTS;
    }

    private Optional<Expression> before(Step step, Expression after) {
        Map<String, Expression> assigned = step.move().assigned();
        boolean alike =
                variables.stream()
                        .allMatch(
                                each -> {
                                    Expression value = assigned.get(each.name());
                                    return value == null || isAlike(each.type(), value.type());
                                });
        return alike
                ? Optional.of(onLetter(step, Replacement.ofVariables(assigned).of(after)))
                : Optional.empty();
    }

    /** Whether values of two types are computed with alike: a range makes no difference. */
    static boolean isAlike(Type one, Type other) {
        return one.equals(other)
                || one instanceof Type.IntegerType first
                        && other instanceof Type.IntegerType second
                        && first.width() == second.width();
    }

    /** That a condition over variables and messages is so on what is read, which has to fit. */
    private Expression possible(Step step, Expression condition) {
        Expression all = Formulas.TRUE;
        for (int i = 0; i < inputs.size(); i++) {
            Optional<Expression> message = step.letter().get(i);
            if (message.isPresent()) {
                all = Formulas.and(all, fits(message.get(), inputs.get(i).type()));
            }
        }
        return Formulas.and(all, onLetter(step, condition));
    }

    /** Whether the value of an expression is a message of a type. */
    private static Expression fits(Expression message, Type type) {
        if (message instanceof Expression.Constant constant) {
            return type.has(constant.value()) ? Formulas.TRUE : Formulas.FALSE;
        }
        return Formulas.not(Hazard.outside(message, type));
    }

    private Expression onLetter(Step step, Expression e) {
        Map<String, Optional<Expression>> messages = new HashMap<>();
        for (int i = 0; i < inputs.size(); i++) {
            messages.put(inputs.get(i).name(), step.letter().get(i));
        }
        return Replacement.ofMessages(messages).of(e);
    }
}
