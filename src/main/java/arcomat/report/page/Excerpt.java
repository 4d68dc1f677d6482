package arcomat.report.page;

import arcomat.source.Position;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;

/**
 * The lines of a place in a model.
 *
 * @param place {@code file:line:column}
 */
record Excerpt(String place, List<Line> lines) {
    /** Of a long place, the beginning says enough. */
    private static final int MOST_LINES = 6;

    private static final int LONGEST_LINE = 300;

    Excerpt {
        lines = List.copyOf(lines);
    }

    /** A line; what the place covers of it is marked. */
    record Line(int number, String before, String marked, String after) {}

    static Excerpt of(Span span) {
        SourceFile file = span.file();
        if (file.text().isEmpty()) {
            return new Excerpt(file.path(), List.of());
        }
        Position start = span.startPosition();
        Position end = span.endPosition();
        List<Line> lines = new ArrayList<>();
        int last = Math.min(end.line(), start.line() + MOST_LINES - 1);
        for (int number = start.line(); number <= last; number++) {
            String text = tabless(file.line(number));
            int from = number == start.line() ? start.column() - 1 : indent(text);
            int to = number == end.line() ? end.column() - 1 : text.length();
            lines.add(line(number, text, from, to));
        }
        return new Excerpt(span.toString(), lines);
    }

    private static Line line(int number, String text, int from, int to) {
        String shown = text.length() > LONGEST_LINE ? text.substring(0, LONGEST_LINE) : text;
        int first = Math.min(from, shown.length());
        int last = Math.max(first, Math.min(to, shown.length()));
        return new Line(
                number,
                shown.substring(0, first),
                shown.substring(first, last),
                shown.substring(last).stripTrailing());
    }

    private static int indent(String line) {
        return line.length() - line.stripLeading().length();
    }

    /** As wide as before, in columns of characters. */
    private static String tabless(String line) {
        return line.replace('\t', ' ');
    }
}
