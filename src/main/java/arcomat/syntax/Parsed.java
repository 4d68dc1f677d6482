package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.tree.Unit;

import java.util.List;
import java.util.Optional;

/**
 * What came of reading a file.
 *
 * @param unit the tree; empty exactly if there are findings
 * @param findings the syntax errors in text order
 */
public record Parsed(Optional<Unit> unit, List<Diagnostic> findings) {
    public Parsed {
        findings = List.copyOf(findings);
    }
}
