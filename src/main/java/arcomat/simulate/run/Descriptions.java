package arcomat.simulate.run;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Says in a line what an alternative is. */
final class Descriptions {
    private Descriptions() {}

    /** {@code driving -> waiting (line 12)}. */
    static String of(StepRelation relation, Trace.Taken taken) {
        return transition(relation.automaton(), taken.transition());
    }

    static String of(List<StepRelation> relations, JointReaction reaction) {
        List<String> causes = new ArrayList<>();
        for (int i = 0; i < relations.size(); i++) {
            causes.add(cause(relations.get(i).automaton(), reaction.reactions().get(i).cause()));
        }
        return String.join(" and ", causes);
    }

    static String of(List<StepRelation> relations, JointStart start, Component component) {
        List<String> states = new ArrayList<>();
        for (int i = 0; i < relations.size(); i++) {
            Automaton automaton = relations.get(i).automaton();
            states.add(automaton.states().get(start.starts().get(i).configuration().state()));
        }
        return "initial " + String.join(" and ", states) + output(component, start.output());
    }

    static String cause(Automaton automaton, Trace.Cause cause) {
        return cause instanceof Trace.Taken taken
                ? transition(automaton, taken.transition())
                : ((Trace.Completed) cause).completion().name().toLowerCase(Locale.ROOT);
    }

    private static String transition(Automaton automaton, Automaton.Transition transition) {
        return automaton.arrow(transition) + Fault.line(transition.span());
    }

    private static String output(Component component, Output output) {
        List<String> messages = new ArrayList<>();
        for (int i = 0; i < output.ports().size(); i++) {
            if (!output.ports().get(i).equals(Sent.SILENCE)) {
                messages.add(component.outputs().get(i).name() + " = " + output.ports().get(i));
            }
        }
        return messages.isEmpty() ? "" : " / " + String.join(", ", messages);
    }
}
