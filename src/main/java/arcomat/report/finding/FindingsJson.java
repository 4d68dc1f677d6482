package arcomat.report.finding;

import arcomat.report.finding.Baseline.Comparison;
import arcomat.report.text.Json;
import arcomat.source.Diagnostic;
import arcomat.source.Fix;
import arcomat.source.Position;
import arcomat.source.RestOfFile;
import arcomat.source.Span;

import com.fasterxml.jackson.annotation.JsonUnwrapped;

import java.util.List;
import java.util.Optional;

/**
 * Findings for programs.
 *
 * @param incomplete files that have more errors than are told, where there are some
 * @param known where there is a baseline, what it knows
 * @param gone where there is a baseline, its entries that nothing was found for
 */
public record FindingsJson(
        int files,
        long errors,
        long warnings,
        Optional<List<String>> incomplete,
        List<Finding> findings,
        List<Meant> suppressed,
        Optional<List<Finding>> known,
        Optional<List<Gone>> gone) {

    /** A finding. */
    public record Finding(
            String code,
            String severity,
            String message,
            @JsonUnwrapped Place place,
            List<Note> related,
            Optional<Repair> fix) {
        public static Finding of(Diagnostic finding) {
            return new Finding(
                    finding.code(),
                    FindingsText.word(finding.severity()),
                    finding.message(),
                    Place.of(finding.span()),
                    finding.related().stream()
                            .map(each -> new Note(each.note(), Place.of(each.span())))
                            .toList(),
                    finding.fix().map(Repair::of));
        }

        public static List<Finding> all(List<Diagnostic> findings) {
            return findings.stream().map(Finding::of).toList();
        }
    }

    /** The end is exclusive. */
    record Place(String file, Offset start, Offset end) {
        static Place of(Span span) {
            return new Place(
                    span.file().path(),
                    Offset.of(span.startPosition(), span.start()),
                    Offset.of(span.endPosition(), span.end()));
        }
    }

    /**
     * Lines and columns count from 1 as in the text output.
     *
     * @param offset in UTF-16 units from 0
     */
    record Offset(int line, int column, int offset) {
        static Offset of(Position position, int offset) {
            return new Offset(position.line(), position.column(), offset);
        }
    }

    record Note(String note, @JsonUnwrapped Place place) {}

    record Repair(String title, List<Edit> edits) {
        static Repair of(Fix fix) {
            return new Repair(
                    fix.title(),
                    fix.edits().stream()
                            .map(each -> new Edit(Place.of(each.span()), each.text()))
                            .toList());
        }
    }

    record Edit(@JsonUnwrapped Place place, String text) {}

    /** What is suppressed, and why. */
    record Meant(@JsonUnwrapped Finding finding, String reason) {}

    /** An entry of a baseline that is of no use any more. */
    record Gone(String code, String file, String fingerprint, int times) {
        static List<Gone> all(Comparison comparison) {
            return comparison.gone().entrySet().stream()
                    .map(each -> of(each.getKey(), each.getValue()))
                    .toList();
        }

        private static Gone of(Baseline.Entry entry, int times) {
            return new Gone(entry.code(), entry.path(), entry.fingerprint(), times);
        }
    }

    public static String render(CheckReport report) {
        List<Diagnostic> findings = report.findings();
        return Json.text(
                new FindingsJson(
                        report.paths().size(),
                        errors(findings),
                        findings.size() - errors(findings),
                        incomplete(findings),
                        Finding.all(findings),
                        report.suppressed().stream()
                                .map(each -> new Meant(Finding.of(each.finding()), each.reason()))
                                .toList(),
                        report.comparison().map(any -> Finding.all(report.known())),
                        report.comparison().map(Gone::all)));
    }

    /**
     * Findings that nothing is known of but themselves.
     *
     * @param files how many were looked at
     */
    public static String render(List<Diagnostic> findings, int files) {
        return Json.text(
                new FindingsJson(
                        files,
                        errors(findings),
                        findings.size() - errors(findings),
                        incomplete(findings),
                        Finding.all(findings),
                        List.of(),
                        Optional.empty(),
                        Optional.empty()));
    }

    private static Optional<List<String>> incomplete(List<Diagnostic> findings) {
        return Optional.of(RestOfFile.files(findings)).filter(files -> !files.isEmpty());
    }

    private static long errors(List<Diagnostic> findings) {
        return findings.stream().filter(Diagnostic::isError).count();
    }
}
