package arcomat.semantics.automaton;

import arcomat.model.Value;

import java.util.Arrays;
import java.util.List;

/**
 * Where an automaton is: its state and the values of its variables. Immutable, with a hash that is
 * computed once, since analyses keep many of them in sets.
 */
public final class Configuration {
    /** After a chaos completion: anything may happen from here on. */
    public static final Configuration CHAOS = new Configuration(-1);

    /** After a forbidden input, for good. */
    public static final Configuration ERROR = new Configuration(-2);

    private static final int GOLDEN = 0x9E3779B1;

    private final int state;
    private final Value[] variables;
    private final int hash;

    public Configuration(int state, Value... variables) {
        this.state = state;
        this.variables = variables;
        this.hash = hash(state, variables);
    }

    /** Counters are small: with a small factor, many of their values together would collide. */
    private static int hash(int state, Value[] variables) {
        int hash = state;
        for (Value value : variables) {
            hash = hash * GOLDEN + value.hashCode();
        }
        return hash ^ hash >>> 15;
    }

    /** Index of the state in the automaton; only for what is neither chaos nor error. */
    public int state() {
        return state;
    }

    /** Values in the order of declaration. */
    public List<Value> variables() {
        return List.of(variables);
    }

    public boolean isState() {
        return state >= 0;
    }

    /** For evaluation only; nobody writes to it. */
    public Value[] slots() {
        return variables;
    }

    @Override
    public boolean equals(Object other) {
        return this == other
                || other instanceof Configuration that
                        && hash == that.hash
                        && state == that.state
                        && Arrays.equals(variables, that.variables);
    }

    @Override
    public int hashCode() {
        return hash;
    }

    @Override
    public String toString() {
        if (this == CHAOS) {
            return "chaos";
        }
        return this == ERROR ? "error" : state + Arrays.toString(variables);
    }
}
