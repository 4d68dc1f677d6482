package arcomat.syntax.layout;

/** The inside of comments. */
final class Comments {
    private Comments() {}

    /** Lines that begin with a star are set below the first one; others are left alone. */
    static String indented(String text, int level) {
        if (!text.startsWith("/*") || text.indexOf('\n') < 0) {
            return text;
        }
        String[] lines = text.split("\n", -1);
        StringBuilder result = new StringBuilder(lines[0].stripTrailing());
        for (int i = 1; i < lines.length; i++) {
            if (!lines[i].strip().startsWith("*")) {
                return text;
            }
            result.append('\n').append("    ".repeat(level)).append(' ').append(lines[i].strip());
        }
        return result.toString();
    }
}
