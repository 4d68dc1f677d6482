package arcomat.report.text;

import arcomat.source.Position;
import arcomat.source.Severity;
import arcomat.source.SourceFile;
import arcomat.source.Span;

/**
 * The source line of a place with the place underlined. A range over several lines shows its first
 * and its last line; of a very long line only the surroundings of the place are shown.
 */
public final class Snippet {
    private static final int WINDOW = 100;
    private static final int LEAD = 40;
    private static final String CUT = "...";

    /** Characters on each side of a place that are looked at, enough to fill the window. */
    private static final int REACH = 500;

    private final Style style;
    private final Severity severity;
    private final StringBuilder out = new StringBuilder();
    private String margin = "";

    private Snippet(Style style, Severity severity) {
        this.style = style;
        this.severity = severity;
    }

    /** Lines that each end in a line break; empty for a place in an empty file. */
    public static String render(Span span, Severity severity, Style style) {
        if (span.file().text().isEmpty()) {
            return "";
        }
        return new Snippet(style, severity).render(span);
    }

    private String render(Span span) {
        SourceFile file = span.file();
        Position start = span.startPosition();
        Position end = span.endPosition();
        if (end.line() > start.line() && end.column() == 1) {
            // A range that ends with a line break ends on the line before it.
            end = new Position(end.line() - 1, length(file, end.line() - 1) + 1);
        }
        margin = " ".repeat(Math.max(5, String.valueOf(end.line()).length() + 1));
        if (start.line() == end.line()) {
            line(file, start.line(), start.column() - 1, end.column() - 1);
        } else {
            line(file, start.line(), start.column() - 1, length(file, start.line()));
            if (end.line() > start.line() + 1) {
                out.append(margin).append(style.quiet(" | ")).append("...\n");
            }
            line(file, end.line(), indent(file, end), end.column() - 1);
        }
        return out.toString();
    }

    private static int length(SourceFile file, int line) {
        return file.lineEnd(line) - file.lineStart(line);
    }

    /** Of the line of a position, as far as the position. */
    private static int indent(SourceFile file, Position end) {
        int start = file.lineStart(end.line());
        int indent = 0;
        while (indent < end.column() - 1
                && Character.isWhitespace(file.text().charAt(start + indent))) {
            indent++;
        }
        return indent;
    }

    /** Shows one line and underlines the offsets {@code [from, to)} of it, at least one column. */
    private void line(SourceFile file, int number, int from, int to) {
        int start = file.lineStart(number);
        int left = boundary(file.text(), Math.max(0, from - REACH) + start);
        int right = boundary(file.text(), Math.min(file.lineEnd(number), start + from + REACH));
        DisplayLine line = DisplayLine.of(file.text().substring(left, right));
        int first = line.column(start + from - left);
        int last = Math.max(first + 1, line.column(start + to - left));
        String text = line.text();
        if (text.length() > WINDOW) {
            // Columns and characters differ only where wide characters occur; cutting is rough
            // there.
            int begin = boundary(text, Math.max(0, Math.min(first - LEAD, text.length() - WINDOW)));
            int end = boundary(text, Math.min(text.length(), begin + WINDOW));
            String before = begin > 0 || left > start ? CUT : "";
            boolean isCut = end < text.length() || right < file.lineEnd(number);
            text = before + text.substring(begin, end) + (isCut ? CUT : "");
            first = first - begin + before.length();
            last = Math.min(last - begin + before.length(), text.length());
        }
        String label = String.valueOf(number);
        text = text.stripTrailing();
        out.append(" ".repeat(margin.length() - label.length()))
                .append(style.quiet(label + (text.isEmpty() ? " |" : " | ")))
                .append(text)
                .append('\n');
        out.append(margin)
                .append(style.quiet(" | "))
                .append(" ".repeat(first))
                .append(style.of(severity, "^".repeat(Math.max(1, last - first))))
                .append('\n');
    }

    /** Between two characters, also where one of them takes two units. */
    private static int boundary(String text, int offset) {
        boolean isInside =
                offset > 0
                        && offset < text.length()
                        && Character.isSurrogatePair(text.charAt(offset - 1), text.charAt(offset));
        return isInside ? offset - 1 : offset;
    }
}
