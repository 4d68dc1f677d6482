package arcomat.world;

import arcomat.source.Diagnostic;

/** Gives up reading a line; the parser goes on with the next one. */
final class Unreadable extends Exception {
    private static final long serialVersionUID = 1L;

    private final transient Diagnostic finding;

    Unreadable(Diagnostic finding) {
        super(finding.message());
        this.finding = finding;
    }

    Diagnostic finding() {
        return finding;
    }
}
