package arcomat.analysis.reachability;

import arcomat.semantics.expression.Fault;

/** What some run of an automaton may show in its last configuration: a reachability property. */
public sealed interface RunProperty {
    /** Takes the sum apart: one answer for each form, and the compiler asks for all of them. */
    <R> R match(Cases<R> cases);

    /**
     * One answer for each form.
     *
     * @param <R> what is answered
     */
    interface Cases<R> {
        R reached(Reached reached);

        R enabled(Enabled enabled);

        R together(Together together);

        R unhandled(Unhandled unhandled);

        R wrong(Wrong wrong);

        R overflow(Overflow overflow);

        R silenced(Silenced silenced);
    }

    /** A state is reached. */
    record Reached(int state) implements RunProperty {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.reached(this);
        }
    }

    /** A transition can be taken. */
    record Enabled(int transition) implements RunProperty {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.enabled(this);
        }
    }

    /** Two transitions are enabled together. */
    record Together(int first, int second, Difference difference) implements RunProperty {
        public Together with(Difference other) {
            return new Together(first, second, other);
        }

        @Override
        public <R> R match(Cases<R> cases) {
            return cases.together(this);
        }
    }

    /** How two transitions that are enabled together have to differ, where both go well. */
    enum Difference {
        ANY,
        OUTPUT,
        TARGET
    }

    /** No transition answers a letter. */
    record Unhandled(int state, boolean silent) implements RunProperty {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.unhandled(this);
        }
    }

    /** A guard, or what a transition sends or assigns, goes wrong. */
    record Wrong(int transition, Fault.Kind kind) implements RunProperty {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.wrong(this);
        }
    }

    /** An integer of a transition does not fit its type, and wraps around. */
    record Overflow(int transition) implements RunProperty {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.overflow(this);
        }
    }

    /** A transition lacks nothing but messages that its guard negates, and no other one answers. */
    record Silenced(int transition) implements RunProperty {
        @Override
        public <R> R match(Cases<R> cases) {
            return cases.silenced(this);
        }
    }
}
