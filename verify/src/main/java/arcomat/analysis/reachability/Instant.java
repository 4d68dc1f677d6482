package arcomat.analysis.reachability;

import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.model.Variable;

/**
 * Where an automaton is at one point of a run, and what it reads there. A formula for what cannot
 * be said may be anything; a claim of it is none.
 *
 * @param <T> formulas of a {@link Logic}
 */
public interface Instant<T> {
    T isIn(int state);

    /** Whether a port carries a message. */
    T has(Port port);

    /** The value of an expression, the same for the same one however often it is asked for. */
    T value(Expression e);

    /** Whether two expressions have the same value, as a message. */
    T areSame(Expression one, Expression other);

    /** That a variable has a value. */
    T is(Variable variable, Value value);

    /** That a variable has the value that an expression has at another instant. */
    T is(Variable variable, Expression value, Instant<T> there);

    /** The state, and all values of variables and messages, are what their types have. */
    T isWellTyped();

    /** After the answer yes: the example's configuration. */
    Reachability.Place place();

    /** After the answer yes: what the example reads; null for silence. */
    Value[] letter();
}
