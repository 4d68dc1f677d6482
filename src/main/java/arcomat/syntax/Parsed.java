package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;

import java.util.List;
import java.util.Optional;

/**
 * What came of reading a file.
 *
 * @param unit the tree; empty exactly if there are findings
 * @param recovered what can be read beside the findings, if there are some and it is enough
 * @param findings the syntax errors in text order
 */
public record Parsed(
        Optional<Unit> unit, Optional<Recovered> recovered, List<Diagnostic> findings) {
    public Parsed {
        findings = List.copyOf(findings);
    }

    /** The tree, with gaps if need be. */
    public Optional<Unit> readable() {
        return unit.or(() -> recovered.map(Recovered::unit));
    }
}
