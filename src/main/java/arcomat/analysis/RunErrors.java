package arcomat.analysis;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;

import java.util.stream.Stream;

/**
 * Whether a run of an automaton may end with an error: by its completion, outside a range, or at a
 * division by zero. Errs on the side of yes.
 */
final class RunErrors {
    private RunErrors() {}

    static boolean arePossible(Automaton automaton) {
        return automaton.completion() == Automaton.Completion.ERROR
                || automaton.transitions().stream().anyMatch(RunErrors::arePossible);
    }

    private static boolean arePossible(Automaton.Transition transition) {
        return !transition.assignments().isEmpty()
                || transition.sends().stream().anyMatch(RunErrors::isCalculated)
                || transition.guard().map(RunErrors::divides).orElse(false);
    }

    private static boolean isCalculated(Automaton.Send send) {
        return send.emission() instanceof Automaton.Messages messages
                && !messages.values().stream().allMatch(Expression.Constant.class::isInstance);
    }

    private static boolean divides(Expression e) {
        if (e instanceof Expression.Unary unary) {
            return divides(unary.operand());
        }
        if (e instanceof Expression.Binary binary) {
            return binary.operator() == BinaryOperator.DIVIDE
                    || binary.operator() == BinaryOperator.REMAINDER
                    || divides(binary.left())
                    || divides(binary.right());
        }
        if (e instanceof Expression.Conditional choice) {
            return Stream.of(choice.condition(), choice.then(), choice.otherwise())
                    .anyMatch(RunErrors::divides);
        }
        if (e instanceof Expression.IsIn isIn) {
            return divides(isIn.element()) || isIn.set().stream().anyMatch(RunErrors::divides);
        }
        if (e instanceof Expression.Cast cast) {
            return divides(cast.operand());
        }
        return e instanceof Expression.AttributeRead read && divides(read.object());
    }
}
