package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict;

/**
 * How a question is told.
 *
 * @param step what a run is made of
 * @param sides who is looked at, as a heading
 * @param left where the left side is
 * @param right where the right side may be
 * @param end what the right side says to the last step
 */
record Terms(String step, String sides, String left, String right, String end) {
    private static final Terms REFINEMENT =
            new Terms("step", "both sides", "left is", "right is", "not possible");
    private static final Terms INVARIANT =
            new Terms("slice", "component", "state", "invariant", "not true");

    static Terms of(Answered answered) {
        return switch (answered.question()) {
            case REFINEMENT -> REFINEMENT;
            case INVARIANT -> INVARIANT;
        };
    }

    /** The answer as a sentence. */
    static String headline(Answered answered) {
        return answered.question() == Answered.Question.INVARIANT
                ? ofInvariant(answered.left(), answered.right(), answered.verdict())
                : ofRefinement(answered.left(), answered.right(), answered.verdict());
    }

    private static String ofInvariant(String left, String name, Verdict verdict) {
        return switch (verdict.answer()) {
            case HOLDS -> left + " keeps invariant " + name;
            case FAILS -> left + " breaks invariant " + name;
            case UNKNOWN ->
                    "whether " + left + " keeps invariant " + name + ": " + verdict.reason();
        };
    }

    private static String ofRefinement(String left, String right, Verdict verdict) {
        return switch (verdict.answer()) {
            case HOLDS -> left + " refines " + right;
            case FAILS -> left + " does not refine " + right + " (" + verdict.reason() + ")";
            case UNKNOWN ->
                    right.isEmpty()
                            ? verdict.reason()
                            : "whether " + left + " refines " + right + ": " + verdict.reason();
        };
    }

    /** What was asked, in short. */
    static String name(Answered answered) {
        if (answered.question() == Answered.Question.INVARIANT) {
            return answered.left() + " keeps invariant " + answered.right();
        }
        return answered.right().isEmpty()
                ? answered.left()
                : answered.left() + " refines " + answered.right();
    }
}
