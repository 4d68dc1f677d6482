package arcomat.report.finding;

import arcomat.report.finding.JunitXml.Case;
import arcomat.report.finding.JunitXml.Case.Outcome;
import arcomat.report.finding.Reported.Standing;
import arcomat.report.text.Style;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Files that were checked as cases, one each, with what was found in them.
 *
 * @param strict whether a warning is a failure
 */
public record FileCases(CheckReport report, boolean strict) {
    private static final String GROUP = "check";

    /** All files, those without findings too. */
    public List<Case> all() {
        SortedMap<String, List<Reported>> byFile = new TreeMap<>();
        report.paths().forEach(path -> byFile.put(path, new ArrayList<>()));
        for (Reported each : report.reported()) {
            byFile.computeIfAbsent(each.finding().span().file().path(), p -> new ArrayList<>())
                    .add(each);
        }
        return byFile.entrySet().stream().map(e -> of(e.getKey(), e.getValue())).toList();
    }

    private Case of(String path, List<Reported> own) {
        List<Diagnostic> open =
                own.stream()
                        .filter(each -> each.standing() == Standing.NEW)
                        .map(Reported::finding)
                        .toList();
        Optional<Diagnostic> failure = open.stream().filter(f -> strict || f.isError()).findFirst();
        Span beginning = new SourceFile(path, "").span(0, 0);
        return new Case(
                GROUP,
                path,
                Optional.of(failure.map(Diagnostic::span).orElse(beginning)),
                failure.isPresent() ? Outcome.FAILED : Outcome.PASSED,
                failure.map(f -> f.code() + ": " + f.message()).orElse(""),
                FindingsText.render(open, Style.PLAIN) + closed(own));
    }

    /** A line for each finding that nobody has to look at. */
    private static String closed(List<Reported> own) {
        StringBuilder lines = new StringBuilder();
        for (Reported each : own) {
            switch (each.standing()) {
                case NEW -> {}
                case SUPPRESSED -> append(lines, each, "suppressed: " + each.reason());
                case KNOWN -> append(lines, each, "known, in baseline");
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
}
