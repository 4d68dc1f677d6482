package arcomat.report.text;

import arcomat.source.Severity;

/** Colours on a terminal, nothing elsewhere. */
public enum Style {
    PLAIN,
    COLOURED;

    private static final String RESET = "\u001b[0m";

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
        return this == PLAIN || text.isEmpty() ? text : "\u001b[" + attributes + "m" + text + RESET;
    }
}
