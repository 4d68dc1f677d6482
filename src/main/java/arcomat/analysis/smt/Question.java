package arcomat.analysis.smt;

import arcomat.semantics.expression.Fault;

/** What some run of an automaton may show in its last configuration. */
public sealed interface Question {

    /** A state is reached. */
    record Reached(int state) implements Question {}

    /** A transition can be taken. */
    record Enabled(int transition) implements Question {}

    /** Two transitions are enabled together. */
    record Together(int first, int second, Difference difference) implements Question {
        public Together with(Difference other) {
            return new Together(first, second, other);
        }
    }

    /** How two transitions that are enabled together have to differ, where both go well. */
    enum Difference {
        ANY,
        OUTPUT,
        TARGET
    }

    /** No transition answers a letter. */
    record Unhandled(int state, boolean silent) implements Question {}

    /** A guard, or what a transition sends or assigns, goes wrong. */
    record Wrong(int transition, Fault.Kind kind) implements Question {}

    /** An integer of a transition does not fit its type, and wraps around. */
    record Overflow(int transition) implements Question {}

    /** An integer variable is odd, or even. */
    record Parity(int variable, boolean odd) implements Question {}

    /** An integer variable is below a bound, or above it. */
    record Beyond(int variable, boolean below, long bound) implements Question {}
}
