package arcomat.guest;

import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.util.List;

/**
 * A form in which results are written: what {@code --format} and {@code --report} name, beside the
 * tool's own.
 */
public interface ReportForm {
    /**
     * What it is called: small letters, digits and hyphens, beginning with a letter, at most 40.
     */
    String form();

    /**
     * The whole text. It depends on the results alone: the same ones give the same text.
     *
     * @param results of a command, by their places
     */
    String render(Results results);

    /**
     * What a command found.
     *
     * @param command {@code check}, {@code verify}, {@code test}, {@code gate} or {@code import}
     */
    record Results(String command, List<Result> results) {
        public Results {
            results = List.copyOf(results);
        }
    }

    /**
     * Something that was found, and whether anything is to be done about it.
     *
     * @param reason why it is meant, where a model says so; else empty
     * @param steps how it comes about, from the first to the last; none where it is no run
     */
    record Result(Diagnostic finding, Standing standing, String reason, List<Step> steps) {
        public Result {
            steps = List.copyOf(steps);
        }
    }

    /** Whether anything is to be done. */
    enum Standing {
        /** Somebody has to look at it. */
        NEW,
        /** A model says that it is meant. */
        SUPPRESSED,
        /** It is in the baseline. */
        KNOWN
    }

    /** Something that happens, and where that is written. */
    record Step(String text, Span place) {}
}
