package arcomat.syntax;

import arcomat.source.Diagnostic;

import java.util.List;
import java.util.Optional;

/**
 * What came of formatting a file.
 *
 * @param text the canonical text; empty exactly if there are findings
 * @param findings the syntax errors in text order
 */
public record Formatted(Optional<String> text, List<Diagnostic> findings) {
    public Formatted {
        findings = List.copyOf(findings);
    }
}
