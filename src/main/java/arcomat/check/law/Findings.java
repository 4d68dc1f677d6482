package arcomat.check.law;

import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Nearest;
import arcomat.source.Severity;
import arcomat.source.Span;
import arcomat.tree.Node;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Collects what one check finds, under the code and the severity of its law. */
public final class Findings {
    private final String code;
    private final Severity severity;
    private final List<Diagnostic> diagnostics = new ArrayList<>();

    public Findings(String code, Severity severity) {
        this.code = code;
        this.severity = severity;
    }

    /**
     * Reports a finding. The message names the thing and says what to do; it starts with a small
     * letter, puts names in single quotes and ends without a full stop.
     *
     * @param values what stands in the message for each {@code %s}; without any, the message is the
     *     text itself
     */
    public Findings report(Node place, String message, Object... values) {
        return report(place.span(), message, values);
    }

    public Findings report(Span place, String message, Object... values) {
        String text = values.length == 0 ? message : String.format(Locale.ROOT, message, values);
        diagnostics.add(new Diagnostic(code, severity, place, text, List.of(), Optional.empty()));
        return this;
    }

    /**
     * Reports a name that nothing has. If one of the candidates is close, the message asks for it
     * and a fix puts it in place.
     *
     * @param otherwise what to do where none is close
     */
    public Findings reportUnknown(
            Span place,
            String message,
            String name,
            Collection<String> candidates,
            String otherwise) {
        Optional<String> nearest = Nearest.to(name, candidates);
        if (nearest.isEmpty()) {
            return report(place, "%s; %s", message, otherwise);
        }
        report(place, "%s; did you mean '%s'?", message, nearest.get());
        String title = "Replace '" + name + "' by '" + nearest.get() + "'";
        return fix(Fix.replace(title, place, nearest.get()));
    }

    /** Adds a related place to the latest finding. */
    public Findings related(Node place, String note) {
        return related(place.span(), note);
    }

    public Findings related(Span place, String note) {
        return replaceLatest(latest().withRelated(place, note));
    }

    /** Adds a safe repair to the latest finding. */
    public Findings fix(Fix fix) {
        return replaceLatest(latest().withFix(fix));
    }

    public void addAll(Findings other) {
        diagnostics.addAll(other.diagnostics);
    }

    public List<Diagnostic> diagnostics() {
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
