package arcomat.report;

import arcomat.report.Case.Outcome;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;

/**
 * Files that were checked as cases, one each, with what was found in them.
 *
 * @param strict whether a warning is a failure
 */
public record FileCases(CheckReport report, boolean strict) {
    private static final String GROUP = "check";

    /** All files, those without findings too. */
    public List<Case> all() {
        SortedSet<String> paths = new TreeSet<>(report.paths());
        report.findings().forEach(finding -> paths.add(finding.span().file().path()));
        return paths.stream().map(this::of).toList();
    }

    private Case of(String path) {
        List<Diagnostic> own = report.findings().stream().filter(f -> isIn(path, f)).toList();
        Optional<Diagnostic> failure = own.stream().filter(f -> strict || f.isError()).findFirst();
        Span beginning = new SourceFile(path, "").span(0, 0);
        return new Case(
                GROUP,
                path,
                Optional.of(failure.map(Diagnostic::span).orElse(beginning)),
                failure.isPresent() ? Outcome.FAILED : Outcome.PASSED,
                failure.map(f -> f.code() + ": " + f.message()).orElse(""),
                FindingsText.render(own, Style.PLAIN) + notShown(path));
    }

    /** A line for each finding that nobody has to look at. */
    private String notShown(String path) {
        StringBuilder lines = new StringBuilder();
        for (Reported each : report.reported()) {
            if (isIn(path, each.finding())) {
                switch (each.standing()) {
                    case NEW -> {}
                    case SUPPRESSED -> append(lines, each, "suppressed: " + each.reason());
                    case KNOWN -> append(lines, each, "known, in baseline");
                }
            }
        }
        return lines.toString();
    }

    private static void append(StringBuilder lines, Reported each, String why) {
        lines.append(FindingsText.place(each.finding().span()))
                .append(": ")
                .append(each.finding().code())
                .append(' ')
                .append(why)
                .append('\n');
    }

    private static boolean isIn(String path, Diagnostic finding) {
        return finding.span().file().path().equals(path);
    }
}
