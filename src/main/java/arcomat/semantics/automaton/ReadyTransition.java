package arcomat.semantics.automaton;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Effect;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Term;
import arcomat.semantics.statement.Carried;

import java.util.Optional;

/**
 * A transition that is ready to be taken: its condition and its right-hand side are compiled.
 *
 * @param carried what is done instead of the effect where statements say it
 */
record ReadyTransition(
        Component component,
        Automaton automaton,
        Term condition,
        Effect effect,
        Optional<Carried> carried,
        Trace.Taken cause) {
    /**
     * @param messages one per input port, null where there is none
     * @throws Fault where the condition goes wrong
     */
    boolean isEnabled(Value[] messages, Value[] variables) {
        try {
            return condition.holds(messages, variables)
                    && (carried.isEmpty() || carried.get().isOpen(messages, variables));
        } catch (Fault fault) {
            throw fault.in(place(), cause);
        }
    }

    /**
     * What an enabled transition does.
     *
     * @throws Fault where the right-hand side goes wrong
     */
    Reaction reaction(Value[] messages, Value[] variables) {
        try {
            if (carried.isPresent()) {
                Carried.Result result = carried.get().result(messages, variables);
                return new Reaction(
                        cause,
                        result.output(),
                        new Configuration(cause.transition().target(), result.variables()));
            }
            Value[] after = effect.variables(messages, variables);
            return new Reaction(
                    cause,
                    effect.output(messages, variables),
                    new Configuration(cause.transition().target(), after));
        } catch (Fault fault) {
            throw fault.in(place(), cause);
        }
    }

    private String place() {
        return Fault.place(component, automaton, cause.transition());
    }
}
