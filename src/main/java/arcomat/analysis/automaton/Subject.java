package arcomat.analysis.automaton;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.semantics.Behaviour;
import arcomat.semantics.StepRelation;

import java.util.List;

/**
 * The automaton that is examined.
 *
 * @param relation its steps, with the ports that it decides about
 */
record Subject(Component component, Automaton automaton, StepRelation relation) {

    /**
     * @throws arcomat.semantics.Fault where constants or initial values go wrong
     */
    static Subject of(Component component, Automaton automaton, List<Value> arguments) {
        Behaviour behaviour = Behaviour.of(component, List.of(automaton), arguments);
        return new Subject(component, automaton, behaviour.relations().get(0));
    }

    Automaton.Transition transition(int index) {
        return automaton.transitions().get(index);
    }

    String state(int index) {
        return automaton.states().get(index);
    }

    /** {@code driving -> waiting}. */
    String move(int transition) {
        Automaton.Transition move = transition(transition);
        return state(move.source()) + " -> " + state(move.target());
    }
}
