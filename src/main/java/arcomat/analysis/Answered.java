package arcomat.analysis;

import arcomat.source.Span;

/**
 * A question with its answer.
 *
 * @param left what is to keep a promise
 * @param right what promises; empty where that is not even known
 * @param place where the left side says that it keeps it
 */
public record Answered(String left, String right, Span place, Verdict verdict) {}
