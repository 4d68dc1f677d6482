package arcomat.semantics;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Variable;
import arcomat.rt.ModelError;
import arcomat.source.Span;

/**
 * The model goes wrong in a step: a value outside its range, a division by zero. Whoever runs the
 * model adds instance and slice. It carries no stack trace: it says something about the model, not
 * about this program.
 */
public final class Fault extends ModelError {
    private static final long serialVersionUID = 1L;

    Fault(String message) {
        super(message);
    }

    @Override
    public synchronized Throwable fillInStackTrace() {
        return this;
    }

    static Fault divisionByZero() {
        return new Fault("division by zero");
    }

    static Fault outsideRange(String name, Object value, String type) {
        return new Fault(name + " = " + value + " is outside " + type);
    }

    Fault in(String place) {
        return new Fault(place + ": " + getMessage());
    }

    /** The place of a transition in messages: {@code AvoidCrash, driving -> waiting (line 12)}. */
    public static String place(
            Component component, Automaton automaton, Automaton.Transition transition) {
        return component.name()
                + ", "
                + automaton.states().get(transition.source())
                + " -> "
                + automaton.states().get(transition.target())
                + line(transition.span());
    }

    /** The place of a state in messages, where no transition is to blame. */
    public static String place(Component component, Automaton automaton, int state) {
        return component.name() + ", in " + automaton.states().get(state);
    }

    /** The place of a value that a variable or a constant starts with. */
    public static String place(Component component, Variable variable) {
        return component.name() + ", value of " + variable.name() + line(variable.span());
    }

    /** The place of the arguments of a part. */
    public static String place(Component component, String part) {
        return component.name() + ", arguments of " + part;
    }

    static String line(Span span) {
        return span == null ? "" : " (line " + span.startPosition().line() + ")";
    }
}
