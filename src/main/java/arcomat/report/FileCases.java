package arcomat.report;

import arcomat.report.Case.Outcome;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Suppressed;

import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;

/** Files that were checked as cases, one each, with what was found in them. */
public final class FileCases {
    private static final String GROUP = "check";

    private final List<Diagnostic> findings;
    private final List<Suppressed> suppressed;
    private final boolean strict;

    private FileCases(List<Diagnostic> findings, List<Suppressed> suppressed, boolean strict) {
        this.findings = findings;
        this.suppressed = suppressed;
        this.strict = strict;
    }

    /**
     * @param paths all files, those without findings too
     * @param strict whether a warning is a failure
     */
    public static List<Case> of(
            List<String> paths,
            List<Diagnostic> findings,
            List<Suppressed> suppressed,
            boolean strict) {
        SortedSet<String> all = new TreeSet<>(paths);
        findings.forEach(finding -> all.add(finding.span().file().path()));
        FileCases cases = new FileCases(findings, suppressed, strict);
        return all.stream().map(cases::of).toList();
    }

    private Case of(String path) {
        List<Diagnostic> own = findings.stream().filter(f -> isIn(path, f)).toList();
        Optional<Diagnostic> failure = own.stream().filter(f -> strict || f.isError()).findFirst();
        return new Case(
                GROUP,
                path,
                Optional.of(
                        failure.map(Diagnostic::span)
                                .orElseGet(() -> new SourceFile(path, "").span(0, 0))),
                failure.isPresent() ? Outcome.FAILED : Outcome.PASSED,
                failure.map(f -> f.code() + ": " + f.message()).orElse(""),
                FindingsText.render(own, Style.PLAIN) + meant(path));
    }

    private String meant(String path) {
        return FindingsText.suppressed(
                suppressed.stream().filter(each -> isIn(path, each.finding())).toList());
    }

    private static boolean isIn(String path, Diagnostic finding) {
        return finding.span().file().path().equals(path);
    }
}
