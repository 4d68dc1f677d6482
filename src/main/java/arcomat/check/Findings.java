package arcomat.check;

import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Severity;
import arcomat.source.Span;
import arcomat.tree.Node;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Collects what one check finds, under the code and the severity of its law. */
final class Findings {
    private final String code;
    private final Severity severity;
    private final List<Diagnostic> diagnostics = new ArrayList<>();

    Findings(String code, Severity severity) {
        this.code = code;
        this.severity = severity;
    }

    /** Reports a finding. The message names the thing and says what to do. */
    Findings report(Node place, String message) {
        return report(place.span(), message);
    }

    Findings report(Span place, String message) {
        diagnostics.add(
                new Diagnostic(code, severity, place, message, List.of(), Optional.empty()));
        return this;
    }

    /** Adds a related place to the latest finding. */
    Findings related(Node place, String note) {
        return related(place.span(), note);
    }

    Findings related(Span place, String note) {
        return replaceLatest(latest().withRelated(place, note));
    }

    /** Adds a safe repair to the latest finding. */
    Findings fix(Fix fix) {
        return replaceLatest(latest().withFix(fix));
    }

    /** Lowers the latest finding to a warning, for a law with cases that are merely doubtful. */
    Findings asWarning() {
        return replaceLatest(latest().withSeverity(Severity.WARNING));
    }

    List<Diagnostic> diagnostics() {
        return diagnostics;
    }

    private Diagnostic latest() {
        return diagnostics.get(diagnostics.size() - 1);
    }

    private Findings replaceLatest(Diagnostic diagnostic) {
        diagnostics.set(diagnostics.size() - 1, diagnostic);
        return this;
    }
}
