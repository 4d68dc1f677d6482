package arcomat.analysis.refinement;

import arcomat.semantics.Promise;
import arcomat.source.Span;

import java.util.List;

/**
 * A question with its answer.
 *
 * @param left what is to keep a promise
 * @param right what promises, or the name of the invariant; empty where that is not even known
 * @param place where the left side says that it keeps it
 * @param sides the two that were compared, left and right; of an invariant, the component alone;
 *     empty where nothing was
 */
public record Answered(
        Question question,
        String left,
        String right,
        Span place,
        Verdict verdict,
        List<Promise> sides) {
    public Answered {
        sides = List.copyOf(sides);
    }

    /** What was asked. */
    public enum Question {
        /** Whether the left side refines the right one. */
        REFINEMENT,
        /** Whether an invariant of the left side is always true. */
        INVARIANT
    }

    /** Whether the left side refines the right one. */
    public Answered(String left, String right, Span place, Verdict verdict, List<Promise> sides) {
        this(Question.REFINEMENT, left, right, place, verdict, sides);
    }

    /** Without a comparison. */
    public Answered(String left, String right, Span place, Verdict verdict) {
        this(left, right, place, verdict, List.of());
    }

    /** Whether an invariant is always true; nobody could ask that of the component. */
    public static Answered ofInvariant(String left, String name, Span place, Verdict verdict) {
        return new Answered(Question.INVARIANT, left, name, place, verdict, List.of());
    }

    /** Whether an invariant is always true. */
    public static Answered ofInvariant(Promise side, String name, Span place, Verdict verdict) {
        return new Answered(Question.INVARIANT, side.title(), name, place, verdict, List.of(side));
    }
}
