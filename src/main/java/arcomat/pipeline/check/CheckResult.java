package arcomat.pipeline.check;

import arcomat.pipeline.file.FileFindings;
import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;

import java.util.ArrayList;
import java.util.List;

/**
 * What checking a set of files found.
 *
 * @param findings in the order in which they are shown, each once
 * @param suppressed what the models declare to be meant, in the same order
 * @param paths the files that were named, one by one or by their folder
 * @param aside what a command went on without
 */
public record CheckResult(
        List<Diagnostic> findings, List<Suppressed> suppressed, List<String> paths, Aside aside) {
    public CheckResult {
        findings = List.copyOf(findings);
        suppressed = List.copyOf(suppressed);
        paths = List.copyOf(paths);
    }

    public CheckResult(List<Diagnostic> findings, List<Suppressed> suppressed, List<String> paths) {
        this(findings, suppressed, paths, Aside.NOTHING);
    }

    /** The number of files that were named. */
    public int files() {
        return paths.size();
    }

    /** The same with other findings. */
    public CheckResult with(List<Diagnostic> others) {
        return new CheckResult(others, suppressed, paths, aside);
    }

    /** What checking both found. */
    public CheckResult and(CheckResult more) {
        List<Diagnostic> all = new ArrayList<>(findings);
        all.addAll(more.findings);
        all.sort(Diagnostic.ORDER);
        List<Suppressed> meant = new ArrayList<>(suppressed);
        meant.addAll(more.suppressed);
        List<String> files = new ArrayList<>(paths);
        files.addAll(more.paths);
        return new CheckResult(all, meant, files);
    }

    public boolean hasErrors() {
        return findings.stream().anyMatch(Diagnostic::isError);
    }

    /** Whether some of the input could not be read at all. */
    public boolean hasUnreadableInput() {
        return findings.stream().anyMatch(FileFindings::isUnreadableInput);
    }
}
