package arcomat.check.guest;

import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.time.Duration;

/**
 * What is told where something of a guest does not come to its end.
 *
 * @param guest whose it is
 */
public record GuestFailure(String guest) {
    /** ARC1201: a law or an analysis of a guest cannot be carried out. */
    private static final String FAILED = "ARC1201";

    /** ARC1202: a guest takes too long. */
    private static final String TOO_LONG = "ARC1202";

    /** A law threw something; it has nothing to say in this run any more. */
    public Diagnostic lawFailed(String code, Span place, Throwable thrown) {
        return failed("law " + code, "failed here and was not asked again", place, thrown);
    }

    /** An analysis threw something at one automaton. */
    public Diagnostic analysisFailed(String codes, Span place, Throwable thrown) {
        return failed("the analysis for " + codes, "failed at this automaton", place, thrown);
    }

    private Diagnostic failed(String what, String how, Span place, Throwable thrown) {
        return Diagnostic.error(
                FAILED,
                place,
                "%s of guest '%s' %s: %s%s; tell who wrote it, or leave the guest out"
                        .formatted(what, guest, how, thrown, where(thrown)));
    }

    /** Nobody waits any longer for what the guest does. */
    public Diagnostic tooLong(String what, Span place, Duration limit) {
        return Diagnostic.error(
                TOO_LONG,
                place,
                "guest '%s' was not done with its %s after %d s and was left alone; tell who wrote it, or leave the guest out"
                        .formatted(guest, what, limit.toSeconds()));
    }

    /** The line of the guest: those of the tool say nothing to its author. */
    private static String where(Throwable thrown) {
        for (StackTraceElement frame : thrown.getStackTrace()) {
            String name = frame.getClassName();
            if (!name.startsWith("arcomat.") && !name.startsWith("java.")) {
                return " at " + frame.getFileName() + ":" + frame.getLineNumber();
            }
        }
        return "";
    }
}
