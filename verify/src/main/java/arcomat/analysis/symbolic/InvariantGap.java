package arcomat.analysis.symbolic;

/**
 * Why an invariant proves nothing. States and inputs are told by the truth of their variables,
 * cubes by literals that count positions of the state from 1 on.
 */
public sealed interface InvariantGap {
    /** A run begins in what is excluded. */
    record Begins(boolean[] state, int[] cube) implements InvariantGap {
        @Override
        public <T> T match(Cases<T> cases) {
            return cases.begins(this);
        }
    }

    /** A step leads to what is excluded, from what is not. */
    record Leads(boolean[] state, boolean[] inputs, boolean[] next, int[] cube)
            implements InvariantGap {
        @Override
        public <T> T match(Cases<T> cases) {
            return cases.leads(this);
        }
    }

    /** A step is bad, from what is not excluded. */
    record Bad(boolean[] state, boolean[] inputs) implements InvariantGap {
        @Override
        public <T> T match(Cases<T> cases) {
            return cases.bad(this);
        }
    }

    /** The solver finds nothing wrong, but its conclusions do not follow. */
    record Inconclusive() implements InvariantGap {
        @Override
        public <T> T match(Cases<T> cases) {
            return cases.inconclusive();
        }
    }

    /** What each kind of gap means to somebody. */
    interface Cases<T> {
        T begins(Begins gap);

        T leads(Leads gap);

        T bad(Bad gap);

        T inconclusive();
    }

    <T> T match(Cases<T> cases);
}
