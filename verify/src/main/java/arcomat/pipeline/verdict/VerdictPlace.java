package arcomat.pipeline.verdict;

import arcomat.source.Span;

/**
 * A place in a text about which something can be asked.
 *
 * @param name tells it from others of the same kind in the file; it stays the same while the text
 *     around it changes
 * @param span what a verdict stands at
 * @param subject the whole of it
 */
public record VerdictPlace(Kind kind, String name, Span span, Span subject) {
    /** What is asked. */
    public enum Kind {
        /** Whether a component refines another one. */
        REFINEMENT,
        /** Whether a composition does what an automaton on it asks. */
        REQUIREMENT,
        /** Whether it does what automata ask that it has from the component that it extends. */
        INHERITED,
        /** What becomes of a component on the brick. */
        PROGRAM,
        /** Whether an invariant is always true. */
        INVARIANT,
        /** What there is to be said about an automaton, or a table. */
        AUTOMATON,
        /** Whether a stream test passes. */
        TEST
    }

    /** Whether it is the same one, in whatever state the text is. */
    public boolean isSame(VerdictPlace other) {
        return kind == other.kind && name.equals(other.name);
    }
}
