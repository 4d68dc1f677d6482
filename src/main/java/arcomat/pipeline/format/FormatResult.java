package arcomat.pipeline.format;

import arcomat.pipeline.file.FileFindings;
import arcomat.source.Diagnostic;

import java.util.List;

/**
 * What formatting a set of files did.
 *
 * @param changed paths of the files whose text was, or would be, changed
 * @param findings why other files were left alone
 * @param files the number of files looked at
 */
public record FormatResult(List<String> changed, List<Diagnostic> findings, int files) {
    public FormatResult {
        changed = List.copyOf(changed);
        findings = List.copyOf(findings);
    }

    public boolean hasUnreadableInput() {
        return findings.stream().anyMatch(FileFindings::isUnreadableInput);
    }
}
