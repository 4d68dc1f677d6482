package arcomat.pipeline;

import arcomat.source.Diagnostic;

import java.util.List;

/**
 * What checking a set of files found.
 *
 * @param findings in the order in which they are shown, each once
 * @param files the number of files that the paths named
 */
public record CheckResult(List<Diagnostic> findings, int files) {
    public CheckResult {
        findings = List.copyOf(findings);
    }

    public boolean hasErrors() {
        return findings.stream().anyMatch(Diagnostic::isError);
    }

    /** Whether some of the input could not be read at all. */
    public boolean hasUnreadableInput() {
        return findings.stream().anyMatch(FileFindings::isUnreadableInput);
    }
}
