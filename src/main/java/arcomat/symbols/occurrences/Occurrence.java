package arcomat.symbols.occurrences;

import arcomat.source.Span;

/**
 * A place where a name stands.
 *
 * @param span the one word
 * @param referent what it stands for there
 */
public record Occurrence(Span span, Referent referent, Role role) {
    /** What a place does to what it names. */
    public enum Role {
        DECLARES,
        /** A value is taken: in conditions and values, in front of an arrow. */
        READS,
        /** A value is given: in outputs and assignments, behind an arrow. */
        WRITES,
        /** Everything else, as a type or a state that is named. */
        REFERS
    }

    public boolean isDeclaration() {
        return role == Role.DECLARES;
    }

    /** Whether an offset is in the word or at one of its ends, where a cursor touches it. */
    public boolean touches(int offset) {
        return span.start() <= offset && offset <= span.end();
    }
}
