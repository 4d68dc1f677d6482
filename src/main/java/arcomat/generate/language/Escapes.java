package arcomat.generate.language;

import java.nio.charset.StandardCharsets;

/** Text of models inside the text of targets: it can end neither a literal nor a comment. */
public final class Escapes {
    private Escapes() {}

    /**
     * One line that is safe in a comment. Backslashes are doubled: in Java a single one could begin
     * a Unicode escape, in C one at the end would continue the line.
     */
    public static String comment(String text) {
        String line = text.replaceAll("[\\s\\p{Cntrl}\\u2028\\u2029]+", " ").strip();
        String safe = line.replace("\\", "\\\\").replace("*/", "* /").replace("/*", "/ *");
        return safe.endsWith("\\") ? safe + " ." : safe;
    }

    /** The inside of a string literal, as the entry {@code escape} of the target asks for. */
    public static String string(TargetLanguage language, String text) {
        return isC(language) ? cString(text) : javaString(text);
    }

    /** The inside of a character literal. */
    public static String character(TargetLanguage language, char c) {
        if (c == '\'') {
            return "\\'";
        }
        return c == '"' ? "\"" : string(language, String.valueOf(c));
    }

    private static boolean isC(TargetLanguage language) {
        return language.entry("escape").orElse("java").equals("c");
    }

    /** The inside of a string literal of Java. */
    static String javaString(String text) {
        StringBuilder result = new StringBuilder();
        for (char c : text.toCharArray()) {
            if (c == '"' || c == '\\') {
                result.append('\\').append(c);
            } else if (c < ' ') {
                result.append(octal(c));
            } else if (c < 127) {
                result.append(c);
            } else {
                result.append(unicode(c));
            }
        }
        return result.toString();
    }

    /** The inside of a string literal of C, in UTF-8. */
    static String cString(String text) {
        StringBuilder result = new StringBuilder();
        for (byte b : text.getBytes(StandardCharsets.UTF_8)) {
            char c = (char) (b & 0xff);
            if (c == '"' || c == '\\' || c == '?') {
                result.append('\\').append(c);
            } else {
                result.append(c < ' ' || c >= 127 ? octal(c) : String.valueOf(c));
            }
        }
        return result.toString();
    }

    private static String octal(char c) {
        return "\\"
                + (char) ('0' + (c >> 6))
                + (char) ('0' + (c >> 3 & 7))
                + (char) ('0' + (c & 7));
    }

    private static String unicode(char c) {
        String digits = "000" + Integer.toHexString(c);
        return "\\u" + digits.substring(digits.length() - 4);
    }
}
