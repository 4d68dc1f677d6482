package arcomat.analysis.automaton.exploration;

import arcomat.analysis.reachability.RunProperty;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Guards;

import java.util.BitSet;
import java.util.List;

/**
 * Whether there certainly is no trap, where configurations cannot be looked at one by one: from
 * each state that may be reached, transitions that depend on nothing but the letter lead to one
 * that sends.
 */
public record SureSending(Knowledge knowledge) {

    /** Whether a trap may have been missed. */
    public boolean isOpen() {
        if (!isToSend(knowledge.subject())) {
            return false;
        }
        BitSet fine = new BitSet();
        int before = -1;
        while (before < fine.cardinality()) {
            before = fine.cardinality();
            for (int i = 0; i < transitions().size(); i++) {
                Transition transition = transitions().get(i);
                boolean good =
                        sends(knowledge.subject(), transition) || fine.get(transition.target());
                if (good && isSure(i)) {
                    fine.set(transition.source());
                }
            }
        }
        for (int state = 0; state < knowledge.subject().automaton().states().size(); state++) {
            if (!fine.get(state) && !knowledge.neverHappens(new RunProperty.Reached(state))) {
                return true;
            }
        }
        return false;
    }

    private List<Transition> transitions() {
        return knowledge.subject().automaton().transitions();
    }

    /** It was enabled once, so it is whenever the same letter comes; and it goes well. */
    private boolean isSure(int transition) {
        int state = transitions().get(transition).source();
        if (!knowledge.happens(new RunProperty.Enabled(transition))) {
            return false;
        }
        boolean fits =
                knowledge.neverHappens(new RunProperty.Wrong(transition, Fault.Kind.OUTSIDE_RANGE));
        for (int i = 0; i < transitions().size() && fits; i++) {
            fits =
                    transitions().get(i).source() != state
                            || knowledge.neverHappens(
                                    new RunProperty.Wrong(i, Fault.Kind.DIVISION_BY_ZERO));
        }
        return fits && !dependsOnThePast(transition);
    }

    /** Reads a variable, or a latched port, which never again is as silent as it was. */
    private boolean dependsOnThePast(int transition) {
        Expression condition =
                new Guards(knowledge.subject().component().profile())
                        .enabledWhen(
                                knowledge.subject().automaton(), transitions().get(transition));
        return condition.contains(Expression.VariableRead.class::isInstance)
                || condition.ports().stream().anyMatch(Port::latched);
    }

    /** Whether a transition may send. */
    public static boolean sends(Subject subject, Automaton.Transition transition) {
        return subject.automaton().omitted() == Automaton.Omitted.FREE
                || transition.sends().stream()
                        .anyMatch(send -> !(send.emission() instanceof Automaton.Silence));
    }

    /** Not one of several requirements that says nothing about outputs. */
    public static boolean isToSend(Subject subject) {
        Component component = subject.component();
        boolean sole =
                component.body() instanceof Component.Atomic atomic
                        && atomic.automata().size() == 1;
        return sole
                ? !component.outputs().isEmpty()
                : subject.automaton().transitions().stream()
                        .anyMatch(transition -> sends(subject, transition));
    }
}
