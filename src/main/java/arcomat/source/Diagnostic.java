package arcomat.source;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * A finding about a text.
 *
 * @param code stable name of the law that is broken, {@code ARC} and four digits; other capital
 *     letters in those of guests
 * @param message names the thing and says what to do
 * @param related other places that explain the finding, in reading order
 * @param fix edits that mend it, only where they are safe
 */
public record Diagnostic(
        String code,
        Severity severity,
        Span span,
        String message,
        List<Related> related,
        Optional<Fix> fix) {

    /**
     * By file, place and code: the order in which findings are shown. Findings that explain
     * themselves by different places are different.
     */
    public static final Comparator<Diagnostic> ORDER =
            Comparator.comparing((Diagnostic d) -> d.span().file().path())
                    .thenComparingInt(d -> d.span().start())
                    .thenComparingInt(d -> d.span().end())
                    .thenComparing(Diagnostic::code)
                    .thenComparing(Diagnostic::message)
                    .thenComparing(Diagnostic::places);

    public Diagnostic {
        related = List.copyOf(related);
    }

    private String places() {
        return related.stream().map(Diagnostic::place).collect(Collectors.joining("; "));
    }

    private static String place(Related related) {
        return "%s %09d %09d"
                .formatted(
                        related.span().file().path(), related.span().start(), related.span().end());
    }

    public static Diagnostic error(String code, Span span, String message) {
        return new Diagnostic(code, Severity.ERROR, span, message, List.of(), Optional.empty());
    }

    public static Diagnostic warning(String code, Span span, String message) {
        return new Diagnostic(code, Severity.WARNING, span, message, List.of(), Optional.empty());
    }

    public boolean isError() {
        return severity == Severity.ERROR;
    }

    public Diagnostic withRelated(Span place, String note) {
        var more = new java.util.ArrayList<>(related);
        more.add(new Related(place, note));
        return new Diagnostic(code, severity, span, message, more, fix);
    }

    public Diagnostic withFix(Fix edits) {
        return new Diagnostic(code, severity, span, message, related, Optional.of(edits));
    }

    public Diagnostic withoutFix() {
        return new Diagnostic(code, severity, span, message, related, Optional.empty());
    }

    public Diagnostic withoutRelated() {
        return new Diagnostic(code, severity, span, message, List.of(), fix);
    }

    public Diagnostic withMessage(String other) {
        return new Diagnostic(code, severity, span, other, related, fix);
    }

    public Diagnostic withSeverity(Severity other) {
        return new Diagnostic(code, other, span, message, related, fix);
    }

    /** Another place that explains a finding, with a note on what is to be seen there. */
    public record Related(Span span, String note) {}
}
