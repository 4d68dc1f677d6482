package arcomat.report.finding;

import arcomat.report.text.Printable;
import arcomat.report.text.Snippet;
import arcomat.report.text.Style;
import arcomat.source.Diagnostic;
import arcomat.source.Diagnostic.Related;
import arcomat.source.RestOfFile;
import arcomat.source.Severity;
import arcomat.source.Span;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Findings for people: where, what, the source line, related places, what to do. */
public final class FindingsText {
    private FindingsText() {}

    /** All findings, each followed by an empty line. */
    public static String render(List<Diagnostic> findings, Style style) {
        StringBuilder out = new StringBuilder();
        for (Diagnostic finding : findings) {
            out.append(render(finding, style)).append('\n');
        }
        return out.toString();
    }

    public static String render(Diagnostic finding, Style style) {
        StringBuilder out = new StringBuilder();
        Severity severity = finding.severity();
        out.append(style.strong(place(finding.span())))
                .append(": ")
                .append(style.of(severity, word(severity) + " " + finding.code()))
                .append(": ")
                .append(message(finding))
                .append('\n')
                .append(Snippet.render(finding.span(), severity, style));
        for (Related related : finding.related()) {
            out.append("  ")
                    .append(place(related.span()))
                    .append(": ")
                    .append(Printable.escape(related.note()))
                    .append('\n')
                    .append(Snippet.render(related.span(), Severity.WARNING, style));
        }
        finding.fix()
                .ifPresent(
                        fix ->
                                out.append("  ")
                                        .append(style.good("help"))
                                        .append(": ")
                                        .append(Printable.escape(fix.title()))
                                        .append('\n'));
        return out.toString();
    }

    /** A message may end in text to be copied, on lines of its own. */
    private static String message(Diagnostic finding) {
        return Stream.of(finding.message().strip().split("\n"))
                .map(line -> line.isBlank() ? "" : "    " + Printable.escape(line))
                .collect(Collectors.joining("\n"))
                .strip();
    }

    /** {@code path:line:column}; a file without text has only a path. */
    public static String place(Span span) {
        String path = Printable.escape(span.file().path());
        return span.file().text().isEmpty() ? path : path + ":" + span.startPosition();
    }

    /** A place by its name and with its lines. */
    public static String placed(Span span, Style style) {
        return "  " + place(span) + "\n" + Snippet.render(span, Severity.WARNING, style);
    }

    static String word(Severity severity) {
        return severity == Severity.ERROR ? "error" : "warning";
    }

    /** One line: {@code 2 errors, 1 warning in 14 files}, and of which files there may be more. */
    public static String summary(List<Diagnostic> findings, int files, Style style) {
        long errors = findings.stream().filter(Diagnostic::isError).count();
        long warnings = findings.size() - errors;
        String in = files == 0 ? "" : " in " + count(files, "file");
        if (findings.isEmpty()) {
            return style.good("no findings") + in;
        }
        String text = "";
        if (errors > 0) {
            text = style.error(count(errors, "error"));
        }
        if (warnings > 0) {
            text += (errors > 0 ? ", " : "") + style.warning(count(warnings, "warning"));
        }
        return text + in + rest(RestOfFile.files(findings));
    }

    private static String rest(List<String> files) {
        return switch (files.size()) {
            case 0 -> "";
            case 1 -> "; the rest of " + Printable.escape(files.get(0)) + " was not looked at";
            default -> "; the rest of " + count(files.size(), "file") + " was not looked at";
        };
    }

    /** As {@link #summary(List, int, Style)}, with what is not shown; a line for each part. */
    public static String summary(CheckReport report, Style style) {
        StringBuilder out = new StringBuilder();
        out.append(summary(report.findings(), report.paths().size(), style));
        if (!report.suppressed().isEmpty()) {
            out.append(", ").append(report.suppressed().size()).append(" suppressed in models");
        }
        if (report.comparison().isPresent()) {
            out.append(", ").append(count(report.known().size(), "known finding"));
            out.append(" in baseline");
        }
        out.append('\n');
        report.comparison().ifPresent(c -> out.append(BaselineText.gone(c.gone(), style)));
        return out.toString();
    }

    /** The same on every machine. What Java knows of locales is not loaded for a short number. */
    public static String digits(long number) {
        return number < 1000 ? Long.toString(number) : String.format(Locale.ROOT, "%,d", number);
    }

    /** {@code 1 file}, {@code 2 files}. */
    public static String count(long number, String noun) {
        return digits(number) + " " + noun + (number == 1 ? "" : "s");
    }

    /** A page about a law, written in Markdown, as plain text for a terminal. */
    public static String explanation(String markdown, Style style) {
        StringBuilder out = new StringBuilder();
        boolean code = false;
        for (String line : markdown.split("\n")) {
            if (line.startsWith("```")) {
                code = !code;
            } else if (code) {
                out.append(line.isEmpty() ? "" : "    " + line).append('\n');
            } else if (line.startsWith("#")) {
                out.append(style.strong(line.replaceFirst("^#+ *", ""))).append('\n');
            } else {
                out.append(line).append('\n');
            }
        }
        return out.toString();
    }
}
