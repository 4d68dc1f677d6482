package arcomat.analysis;

import arcomat.source.Span;

import java.util.List;

/**
 * A question with its answer.
 *
 * @param left what is to keep a promise
 * @param right what promises; empty where that is not even known
 * @param place where the left side says that it keeps it
 * @param sides the two that were compared, left and right; empty where nothing was
 */
public record Answered(
        String left, String right, Span place, Verdict verdict, List<Promise> sides) {
    public Answered {
        sides = List.copyOf(sides);
    }

    /** Without a comparison. */
    public Answered(String left, String right, Span place, Verdict verdict) {
        this(left, right, place, verdict, List.of());
    }
}
