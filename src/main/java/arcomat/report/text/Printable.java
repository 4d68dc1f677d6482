package arcomat.report.text;

import java.util.Locale;

/**
 * Text of models made safe to show: characters that would move the cursor, ring, colour or reorder
 * what a terminal shows become escapes as Java writes them.
 */
public final class Printable {
    private Printable() {}

    /** The name of a constant as a word: {@code is refined by}. */
    public static String word(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }

    public static String escape(String text) {
        if (text.codePoints().allMatch(Printable::isSafe)) {
            return text;
        }
        StringBuilder escaped = new StringBuilder();
        text.codePoints().forEach(c -> append(escaped, c));
        return escaped.toString();
    }

    /** As {@link #escape}, but keeps line breaks and tabs. */
    public static String escapeKeepingLayout(String text) {
        StringBuilder escaped = new StringBuilder();
        text.codePoints()
                .forEach(
                        c -> {
                            if (c == '\n' || c == '\t') {
                                escaped.appendCodePoint(c);
                            } else {
                                append(escaped, c);
                            }
                        });
        return escaped.toString();
    }

    private static void append(StringBuilder out, int c) {
        if (isSafe(c)) {
            out.appendCodePoint(c);
            return;
        }
        for (char unit : Character.toChars(c)) {
            out.append(String.format("\\u%04x", (int) unit));
        }
    }

    static boolean isSafe(int c) {
        if (c >= ' ' && c <= '~') {
            return true;
        }
        return switch (Character.getType(c)) {
            case Character.CONTROL,
                    Character.FORMAT,
                    Character.SURROGATE,
                    Character.LINE_SEPARATOR,
                    Character.PARAGRAPH_SEPARATOR,
                    Character.PRIVATE_USE,
                    Character.UNASSIGNED ->
                    false;
            default -> true;
        };
    }
}
