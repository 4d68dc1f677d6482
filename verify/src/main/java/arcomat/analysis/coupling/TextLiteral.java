package arcomat.analysis.coupling;

import java.util.Optional;

/** Reads texts and characters as values write them: in quotes, with escapes. */
final class TextLiteral {
    private static final String SIMPLE = "nrt\\\"'";
    private static final String MEANINGS = "\n\r\t\\\"'";
    private static final int DIGITS = 4;
    private static final int HEXADECIMAL = 16;

    private final String text;
    private final char quote;
    private final StringBuilder read = new StringBuilder();
    private int at = 1;

    private TextLiteral(String text, char quote) {
        this.text = text;
        this.quote = quote;
    }

    /** What stands between two quotes; empty where a text is not written like this. */
    static Optional<String> read(String text, char quote) {
        boolean quoted =
                text.length() > 1
                        && text.charAt(0) == quote
                        && text.charAt(text.length() - 1) == quote;
        return quoted ? new TextLiteral(text, quote).value() : Optional.empty();
    }

    private Optional<String> value() {
        while (at < text.length() - 1) {
            char c = text.charAt(at++);
            if (c == quote || c == '\\' && !isEscape()) {
                return Optional.empty();
            }
            if (c != '\\') {
                read.append(c);
            }
        }
        return at == text.length() - 1 ? Optional.of(read.toString()) : Optional.empty();
    }

    /** Reads on behind a backslash. */
    private boolean isEscape() {
        char c = text.charAt(at++);
        int simple = SIMPLE.indexOf(c);
        if (simple >= 0) {
            read.append(MEANINGS.charAt(simple));
            return true;
        }
        return c == 'u' && isCode();
    }

    private boolean isCode() {
        int end = at + DIGITS;
        if (end >= text.length()) {
            return false;
        }
        String digits = text.substring(at, end);
        at = end;
        if (!digits.matches("[0-9a-fA-F]{4}")) {
            return false;
        }
        read.append((char) Integer.parseInt(digits, HEXADECIMAL));
        return true;
    }
}
