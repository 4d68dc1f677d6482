package arcomat.semantics.expression;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.model.Variable;
import arcomat.rt.ModelError;
import arcomat.source.Span;

import org.jspecify.annotations.Nullable;

import java.util.Optional;

/**
 * The model goes wrong in a step: a value outside its range, a division by zero. Whoever runs the
 * model adds instance and slice. It carries no stack trace: it says something about the model, not
 * about this program.
 */
public final class Fault extends ModelError {
    private static final long serialVersionUID = 1L;

    /** What can go wrong. */
    public enum Kind {
        DIVISION_BY_ZERO,
        OUTSIDE_RANGE
    }

    private final Kind kind;
    private final String problem;
    private final transient Trace.@Nullable Taken taken;

    private Fault(Kind kind, String problem, String message, Trace.@Nullable Taken taken) {
        super(message);
        this.kind = kind;
        this.problem = problem;
        this.taken = taken;
    }

    public Kind kind() {
        return kind;
    }

    /** What goes wrong, without the place. */
    public String problem() {
        return problem;
    }

    /** The transition whose guard or right-hand side goes wrong, if it is one. */
    public Optional<Trace.Taken> taken() {
        return Optional.ofNullable(taken);
    }

    @Override
    public synchronized Throwable fillInStackTrace() {
        return this;
    }

    static Fault divisionByZero() {
        String problem = "division by zero";
        return new Fault(Kind.DIVISION_BY_ZERO, problem, problem, null);
    }

    static Fault outsideRange(String name, Object value, String type) {
        String problem = name + " = " + value + " is outside " + type;
        return new Fault(Kind.OUTSIDE_RANGE, problem, problem, null);
    }

    public Fault in(String place) {
        return new Fault(kind, problem, place + ": " + getMessage(), taken);
    }

    public Fault in(String place, Trace.Taken transition) {
        return new Fault(kind, problem, place + ": " + getMessage(), transition);
    }

    /** The place of a transition in messages: {@code AvoidCrash, driving -> waiting (line 12)}. */
    public static String place(
            Component component, Automaton automaton, Automaton.Transition transition) {
        return component.name() + ", " + automaton.arrow(transition) + line(transition.span());
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

    public static String line(@Nullable Span span) {
        return span == null ? "" : " (line " + span.startPosition().line() + ")";
    }
}
