package arcomat.pipeline;

import arcomat.analysis.Verdict;

/**
 * A question with its answer.
 *
 * @param left what is to keep a promise
 * @param right what promises
 */
public record Answered(String left, String right, Verdict verdict) {}
