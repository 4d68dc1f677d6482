package arcomat.semantics.expression;

import arcomat.model.Value;

import org.jspecify.annotations.Nullable;

/** An expression that is ready to be evaluated. */
@FunctionalInterface
public interface Term {
    /**
     * The value in a configuration and letter.
     *
     * @param ports one per input port of the component, null where there is no message
     * @param variables of the automaton
     * @return null where undefined, since an absent port is read
     * @throws Fault for a division by zero
     */
    @Nullable Value evaluate(Value[] ports, Value[] variables);

    /** Whether a condition is true; it may be undefined. */
    default boolean isTrue(Value[] ports, Value[] variables) {
        Value value = evaluate(ports, variables);
        return value != null && ((Value.BooleanValue) value).value();
    }

    /** Whether a two-valued condition holds. */
    @SuppressWarnings("NullAway") // it is always defined
    default boolean holds(Value[] ports, Value[] variables) {
        return ((Value.BooleanValue) evaluate(ports, variables)).value();
    }
}
