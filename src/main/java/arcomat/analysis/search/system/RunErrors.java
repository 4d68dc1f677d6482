package arcomat.analysis.search.system;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.semantics.network.Network;

/**
 * Whether a run of an automaton may end with an error: by its completion, outside a range, or at a
 * division by zero. Errs on the side of yes.
 */
public final class RunErrors {
    private RunErrors() {}

    /** Of a composition: where events queue up, there may be no room for one more. */
    public static boolean arePossible(Network network) {
        return network.component().profile() == Component.Profile.EVENT_DRIVEN
                || network.instances().stream()
                        .flatMap(instance -> instance.component().automata().stream())
                        .anyMatch(RunErrors::arePossible);
    }

    public static boolean arePossible(Automaton automaton) {
        return automaton.completion() == Automaton.Completion.ERROR
                || automaton.transitions().stream().anyMatch(RunErrors::arePossible);
    }

    private static boolean arePossible(Automaton.Transition transition) {
        return transition.assignments().stream()
                        .anyMatch(a -> isCalculated(a.value(), a.variable().type()))
                || transition.sends().stream().anyMatch(RunErrors::isCalculated)
                || transition.matches().stream().anyMatch(match -> divides(match.pattern()))
                || transition.guard().map(RunErrors::divides).orElse(false);
    }

    private static boolean divides(Automaton.Pattern pattern) {
        return pattern instanceof Automaton.OneOf oneOf
                && oneOf.values().stream().anyMatch(RunErrors::divides);
    }

    private static boolean isCalculated(Automaton.Send send) {
        return send.emission() instanceof Automaton.Messages messages
                && messages.values().stream()
                        .anyMatch(value -> isCalculated(value, send.port().type()));
    }

    /** What is written down, or copied from where it had the same type, is never out of range. */
    private static boolean isCalculated(Expression value, Type target) {
        return !(value instanceof Expression.Constant)
                && !(isCopied(value) && value.type().equals(target));
    }

    private static boolean isCopied(Expression value) {
        return value instanceof Expression.VariableRead || value instanceof Expression.PortRead;
    }

    private static boolean divides(Expression e) {
        boolean itself =
                e instanceof Expression.Binary binary
                        && (binary.operator() == BinaryOperator.DIVIDE
                                || binary.operator() == BinaryOperator.REMAINDER);
        return itself || e.operands().stream().anyMatch(RunErrors::divides);
    }
}
