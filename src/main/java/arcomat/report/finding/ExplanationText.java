package arcomat.report.finding;

import arcomat.report.text.Style;

/** A page about a law, written in Markdown, as plain text for a terminal. */
public final class ExplanationText {
    private ExplanationText() {}

    public static String render(String markdown, Style style) {
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
