package arcomat.report.run;

import arcomat.model.Trace;
import arcomat.report.text.Printable;
import arcomat.source.Span;

/** Why an automaton made its step, in words. */
public final class CauseText {
    private static final int LONGEST = 90;

    private CauseText() {}

    /** The transition as the model has it, with its place; or the completion with its effect. */
    public static String of(Trace.Cause cause) {
        if (cause instanceof Trace.Taken taken) {
            Span span = taken.transition().span();
            return withoutStates(span.text()) + "  " + shortPlace(span);
        }
        return switch (((Trace.Completed) cause).completion()) {
            case CHAOS -> "no transition fits: anything may happen (chaos), nothing does";
            case OUTPUT -> "no transition fits: any output is allowed, none is sent";
            case IGNORE -> "no transition fits: the input is ignored";
            case ERROR -> "no transition fits: the input is forbidden (error)";
        };
    }

    /** {@code transition 3} or the name of a completion, for programs. */
    static String brief(Trace.Cause cause) {
        return cause instanceof Trace.Taken taken
                ? "transition " + taken.index()
                : Printable.word(((Trace.Completed) cause).completion());
    }

    /** States have a column of their own. */
    private static String withoutStates(String transition) {
        String line = transition.replaceAll("\\s+", " ").strip();
        line = line.replaceFirst("^[\\w$]+( ?-> ?[\\w$]+)? ?(?=[\\[{/;])", "");
        line = line.replaceFirst(";$", "").strip();
        line = Printable.escape(line.isEmpty() ? "always" : line);
        return line.length() <= LONGEST ? line : line.substring(0, LONGEST - 3) + "...";
    }

    private static String shortPlace(Span span) {
        String path = span.file().path();
        String name = path.substring(path.lastIndexOf('/') + 1);
        return "(" + Printable.escape(name) + ":" + span.startPosition().line() + ")";
    }
}
