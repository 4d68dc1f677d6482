package arcomat.syntax;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.syntax.Reading.Leaves;
import arcomat.syntax.layout.Layout;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Sets a file in canonical white space: four spaces for each level, one element to a line, lines of
 * at most 100 characters where they can be broken. Line breaks are all like the first one of the
 * file. Tokens and comments are kept as they are, single blank lines too. Formatting twice gives
 * the same text as formatting once.
 */
public final class Formatter {
    private Formatter() {}

    /** A file with syntax errors is not formatted; its findings tell why. */
    public static Formatted format(SourceFile file) {
        return Reading.use(file, Leaves.KEPT, Formatter::formatted);
    }

    private static Formatted formatted(Reading reading) {
        if (!reading.findings().isEmpty()) {
            return new Formatted(Optional.empty(), reading.findings());
        }
        String text =
                Layout.format(
                        reading.file().text(),
                        reading.tokens().getTokens(),
                        Objects.requireNonNull(reading.root()));
        boolean isWindows = breaksLikeWindows(reading.file().text());
        return new Formatted(Optional.of(isWindows ? text.replace("\n", "\r\n") : text), List.of());
    }

    private static boolean breaksLikeWindows(String text) {
        int first = text.indexOf('\n');
        return first > 0 && text.charAt(first - 1) == '\r';
    }

    /**
     * What came of formatting a file.
     *
     * @param text the canonical text; empty exactly if there are findings
     * @param findings the syntax errors in text order
     */
    public record Formatted(Optional<String> text, List<Diagnostic> findings) {
        public Formatted {
            findings = List.copyOf(findings);
        }
    }
}
