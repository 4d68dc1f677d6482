package arcomat.benchmarks.analysis;

/** The components of each comparison: {@code load.A} is to refine {@code load.B}. */
final class Cases {
    private static final long SEED = 7;

    private Cases() {}

    /** Nondeterministic automata over four letters; the left one has half of the alternatives. */
    static String[] random(int states) {
        return new String[] {
            Texts.random("A", states, 50, SEED), Texts.random("B", states, 100, SEED)
        };
    }

    /** Counters of coprime lengths: all pairs are met. */
    static String[] counters(int one, int other) {
        return new String[] {Texts.counter("A", one), Texts.counter("B", other)};
    }

    /** Three inputs and three outputs; the right one leaves out a third of the transitions. */
    static String[] wide(int states) {
        return new String[] {Texts.wide("A", states, 0, SEED), Texts.wide("B", states, 30, SEED)};
    }

    /** A hundred parts, each of which refines its namesake. */
    static String[] pipelines() {
        return new String[] {
            Texts.stage("P", true),
            Texts.stage("Q", false),
            Texts.pipeline("A", "P", 100),
            Texts.pipeline("B", "Q", 100)
        };
    }
}
