package arcomat.sim;

import arcomat.sim.load.LoadedProgram;

import java.util.Optional;

/**
 * How a program stands.
 *
 * @param error what it did not catch; present exactly for {@link Kind#FAILED}
 */
public record Outcome(Kind kind, Optional<Throwable> error) {
    /** The ways to stand. */
    public enum Kind {
        RUNNING,
        /** All its threads have ended, or it has called exit. */
        ENDED,
        /**
         * It was stopped from outside: by the end of a script, or because the laboratory closed.
         */
        STOPPED,
        /** ENTER and ESCAPE were pressed together. */
        ABORTED,
        /** A thread ended with an error that nothing caught. */
        FAILED
    }

    static Outcome of(Kind kind) {
        return new Outcome(kind, Optional.empty());
    }

    static Outcome failed(Throwable error) {
        return new Outcome(Kind.FAILED, Optional.of(error));
    }

    /** What went wrong, for the user of the program: the error and where it arose; else empty. */
    public Optional<String> failure() {
        return error.map(Outcome::describe);
    }

    private static String describe(Throwable error) {
        Throwable cause = error;
        while (cause.getCause() != null && cause instanceof LinkageError) {
            cause = cause.getCause();
        }
        StackTraceElement[] trace = error.getStackTrace();
        for (StackTraceElement element : trace) {
            if (isOfProgram(element)) {
                return "%s at %s.%s (%s:%d)"
                        .formatted(
                                text(cause),
                                element.getClassName(),
                                LoadedProgram.written(element.getMethodName()),
                                element.getFileName(),
                                element.getLineNumber());
            }
        }
        return text(cause);
    }

    /** A program's own error may fail to say what it is. */
    private static String text(Throwable error) {
        try {
            return error.toString();
        } catch (RuntimeException | Error e) {
            return error.getClass().getName();
        }
    }

    private static boolean isOfProgram(StackTraceElement element) {
        String name = element.getClassName();
        return !name.startsWith("java.")
                && !name.startsWith("jdk.")
                && !name.startsWith("lejos.")
                && !name.startsWith("arcomat.sim.")
                && !LoadedProgram.isAdded(element.getMethodName());
    }
}
