package arcomat.check;

import arcomat.source.Diagnostic;
import arcomat.source.Position;
import arcomat.source.SourceFile;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A finding that a data file expects, as it stands below the line that it is about: {@code // ~~~
 * error ARC0104: message}. The tildes stand below the text that is underlined; the message may be
 * left out.
 *
 * @param endColumn behind the last tilde; a finding over several lines is underlined to the end of
 *     its first
 */
public record Expectation(
        String path, int line, int startColumn, int endColumn, String finding, String message) {

    private static final Pattern LINE =
            Pattern.compile("//(\\s*)(~+) (error|warning) (ARC\\d{4})(?:: (.*))?");

    static boolean isExpectation(String text) {
        return LINE.matcher(text).matches();
    }

    static Expectation parse(String path, int line, String text) {
        Matcher matcher = LINE.matcher(text);
        if (!matcher.matches()) {
            throw new IllegalArgumentException(text);
        }
        return new Expectation(
                path,
                line,
                matcher.start(2) + 1,
                matcher.end(2) + 1,
                matcher.group(3) + " " + matcher.group(4),
                matcher.group(5) == null ? "" : matcher.group(5).strip());
    }

    public static Expectation of(Diagnostic diagnostic) {
        SourceFile file = diagnostic.span().file();
        Position start = diagnostic.span().startPosition();
        Position end = diagnostic.span().endPosition();
        int endColumn =
                end.line() == start.line()
                        ? end.column()
                        : file.line(start.line()).stripTrailing().length() + 1;
        return new Expectation(
                file.path(),
                start.line(),
                start.column(),
                Math.max(endColumn, start.column() + 1),
                diagnostic.severity().name().toLowerCase(Locale.ROOT) + " " + diagnostic.code(),
                diagnostic.message());
    }

    public String code() {
        return finding.substring(finding.length() - "ARC0000".length());
    }

    public boolean isMetBy(Expectation actual) {
        return actual.withoutMessage().equals(withoutMessage())
                && (message.isEmpty() || message.equals(actual.message));
    }

    private Expectation withoutMessage() {
        return new Expectation(path, line, startColumn, endColumn, finding, "");
    }

    /** The line as it would stand in the data file. */
    String text() {
        return "//"
                + " ".repeat(Math.max(0, startColumn - 3))
                + "~".repeat(endColumn - startColumn)
                + " "
                + finding
                + (message.isEmpty() ? "" : ": " + message);
    }
}
