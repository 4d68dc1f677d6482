package arcomat.analysis.search.system;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.semantics.expression.Interval;
import arcomat.semantics.network.Network;

/**
 * Whether a run of an automaton may end with an error: by its completion, outside a range, or at a
 * division by zero. Errs on the side of yes.
 */
public final class RunErrors {
    private static final Interval ZERO = Interval.of(0, 0);

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
                        .anyMatch(a -> goesWrong(a.value(), a.variable().type()))
                || transition.sends().stream().anyMatch(RunErrors::goesWrong)
                || transition.matches().stream().anyMatch(match -> divides(match.pattern()))
                || transition.guard().map(RunErrors::divides).orElse(false);
    }

    private static boolean divides(Automaton.Pattern pattern) {
        return pattern instanceof Automaton.OneOf oneOf
                && oneOf.values().stream().anyMatch(RunErrors::divides);
    }

    private static boolean goesWrong(Automaton.Send send) {
        return send.emission().values().stream()
                .anyMatch(value -> goesWrong(value, send.port().type()));
    }

    private static boolean goesWrong(Expression value, Type target) {
        return divides(value) || mayLeave(target, value);
    }

    /** Only types with a range can be left. */
    private static boolean mayLeave(Type target, Expression value) {
        return target instanceof Type.IntegerType integer
                && integer.ranged()
                && !Interval.of(value).isWithin(Interval.of(integer.low(), integer.high()));
    }

    /** Only integers have no quotient by zero. */
    private static boolean divides(Expression e) {
        return e.contains(
                part ->
                        part instanceof Expression.Binary binary
                                && (binary.operator() == BinaryOperator.DIVIDE
                                        || binary.operator() == BinaryOperator.REMAINDER)
                                && Interval.isInteger(binary.type())
                                && ZERO.isWithin(Interval.of(binary.right())));
    }
}
