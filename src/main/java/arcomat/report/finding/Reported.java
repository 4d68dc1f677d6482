package arcomat.report.finding;

import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.util.List;

/**
 * A finding as reports for machines show it.
 *
 * @param reason why it is meant, where it is
 * @param steps how it comes about, from the first to the last
 */
public record Reported(Diagnostic finding, Standing standing, String reason, List<Step> steps) {
    public Reported {
        steps = List.copyOf(steps);
    }

    /** Whether anything is to be done. */
    public enum Standing {
        /** Somebody has to look at it. */
        NEW,
        /** A model says that it is meant. */
        SUPPRESSED,
        /** It is in the baseline. */
        KNOWN
    }

    /** Something that happens, and where that is written. */
    public record Step(String text, Span place) {}

    public static Reported of(Diagnostic finding, Standing standing) {
        return new Reported(finding, standing, "", List.of());
    }
}
