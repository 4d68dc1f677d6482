package arcomat.syntax.layout;

import java.util.ArrayList;
import java.util.List;

/** Breaks a line into lines that fit, at the shallowest places that suffice. */
final class Wrapping {
    static final int WIDTH = 100;
    private static final int DEEPEST = 8;
    private static final String UNIT = "    ";

    private Wrapping() {}

    static String wrap(Line line) {
        String indent = UNIT.repeat(line.level);
        for (int depth = -1; depth < DEEPEST; depth++) {
            List<String> lines = fill(line.pieces, indent, depth);
            if (fits(lines)) {
                return String.join("\n", lines);
            }
        }
        return String.join("\n", fill(line.pieces, indent, DEEPEST));
    }

    /** A text of several lines, foreign or a comment, is left alone. */
    private static boolean fits(List<String> lines) {
        for (String line : lines) {
            int comment = line.indexOf(" //");
            int length = comment < 0 ? line.length() : comment;
            if (length > WIDTH && line.indexOf('\n') < 0) {
                return false;
            }
        }
        return true;
    }

    private static List<String> fill(List<Line.Piece> pieces, String indent, int depth) {
        List<String> lines = new ArrayList<>();
        StringBuilder line = new StringBuilder(indent);
        boolean empty = true;
        int i = 0;
        while (i < pieces.size()) {
            String chunk = chunk(pieces, i, depth);
            Line.Piece first = pieces.get(i);
            boolean tooLong = line.length() + 1 + chunk.length() > WIDTH;
            if (!empty && (first.breakBefore() || tooLong && mayBreak(first, depth))) {
                lines.add(line.toString());
                line = new StringBuilder(indent).append(UNIT).append(UNIT);
                empty = true;
            }
            line.append(!empty && first.space() ? " " : "").append(chunk);
            empty = false;
            i = chunkEnd(pieces, i, depth);
        }
        lines.add(line.toString());
        return lines;
    }

    private static boolean mayBreak(Line.Piece piece, int depth) {
        return piece.breakLevel() >= 0 && piece.breakLevel() <= depth;
    }

    /** The pieces from one place to break to the next. */
    private static int chunkEnd(List<Line.Piece> pieces, int start, int depth) {
        int end = start + 1;
        while (end < pieces.size()
                && !mayBreak(pieces.get(end), depth)
                && !pieces.get(end).breakBefore()) {
            end++;
        }
        return end;
    }

    private static String chunk(List<Line.Piece> pieces, int start, int depth) {
        StringBuilder text = new StringBuilder(pieces.get(start).text());
        for (Line.Piece piece : pieces.subList(start + 1, chunkEnd(pieces, start, depth))) {
            text.append(piece.space() ? " " : "").append(piece.text());
        }
        return text.toString();
    }
}
