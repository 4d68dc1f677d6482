package arcomat.report.finding;

import arcomat.source.Span;

import java.util.Optional;

/**
 * One thing that was looked at, with what came of it: a stream test, a promise, a file.
 *
 * @param group what it belongs to: a suite, a component
 * @param name unique in its group
 * @param place where it is written; a file without text is a place too
 * @param message in one sentence why it is not in order; empty where it is
 * @param details in lines what else there is to say, also of what is in order
 */
public record Case(
        String group,
        String name,
        Optional<Span> place,
        Outcome outcome,
        String message,
        String details) {

    /** What came of it. */
    public enum Outcome {
        PASSED,
        FAILED,
        /** Nobody knows: it could not be decided. */
        UNDECIDED
    }
}
