package arcomat.report.text;

import arcomat.source.Severity;

/**
 * Colours on a terminal, nothing elsewhere.
 *
 * @param width how many characters a line of a table may have
 */
public record Style(boolean coloured, int width) {
    /** For programs and files, where no line ends at a border. */
    public static final Style PLAIN = new Style(false, Integer.MAX_VALUE);

    public static final Style COLOURED = new Style(true, Integer.MAX_VALUE);

    private static final String RESET = "\u001b[0m";

    /** The same where lines end at a border. */
    public Style within(int columns) {
        return new Style(coloured, columns);
    }

    public String error(String text) {
        return paint("1;31", text);
    }

    public String warning(String text) {
        return paint("1;33", text);
    }

    public String good(String text) {
        return paint("32", text);
    }

    public String quiet(String text) {
        return paint("2", text);
    }

    public String strong(String text) {
        return paint("1", text);
    }

    public String of(Severity severity, String text) {
        return severity == Severity.ERROR ? error(text) : warning(text);
    }

    private String paint(String attributes, String text) {
        return !coloured || text.isEmpty() ? text : "\u001b[" + attributes + "m" + text + RESET;
    }
}
