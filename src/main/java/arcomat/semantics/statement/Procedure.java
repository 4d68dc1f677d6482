package arcomat.semantics.statement;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Variable;

import java.util.List;

/**
 * Statements as they are carried out: one after the other, with the meaning that they have as
 * transitions. What may go wrong, or reads a port that may be silent, is not computed before it is
 * certain that it is needed.
 *
 * @param entry a two-valued condition without which nothing is done
 * @param locals variables that are known in all steps, with what they hold in the beginning
 * @param steps what is done
 */
public record Procedure(Expression entry, List<Step.Declare> locals, List<Step> steps) {
    public Procedure {
        locals = List.copyOf(locals);
        steps = List.copyOf(steps);
    }

    /** How a procedure is made. */
    public enum Form {
        /** What is sent is sent at the place of its statement. */
        AT_ONCE,
        /** What is sent is sent at the end, as it has to be where events wait in queues. */
        AT_THE_END
    }

    /**
     * The statements of an automaton of a component.
     *
     * @param counts whether there are steps that count the number of the way that is gone
     */
    public static Procedure of(
            Component component,
            Automaton automaton,
            Automaton.Body body,
            Form form,
            boolean counts) {
        Carrying direct =
                new Carrying(component, automaton, form == Form.AT_THE_END, false, counts);
        Procedure procedure = direct.procedure(body);
        return direct.mayTakeBack()
                ? new Carrying(component, automaton, true, true, counts).procedure(body)
                : procedure;
    }

    /** Whether it may come out in the middle that nothing is to be done. */
    public boolean stops() {
        return stops(steps);
    }

    private static boolean stops(List<Step> steps) {
        return steps.stream()
                .anyMatch(
                        each ->
                                each instanceof Step.Need
                                        || each instanceof Step.Choose choose
                                                && (stops(choose.then())
                                                        || stops(choose.otherwise())));
    }

    /** The local variables that are declared somewhere. */
    static boolean isLocal(Automaton automaton, Variable variable) {
        return automaton.variables().stream()
                .noneMatch(each -> each.name().equals(variable.name()));
    }
}
