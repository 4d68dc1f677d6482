package arcomat.source;

import org.jspecify.annotations.Nullable;

import java.util.Arrays;

/**
 * A text with the path it was read from. Positions are offsets in UTF-16 units from 0; lines and
 * columns count from 1. The text is kept exactly as read but for a byte order mark.
 */
public final class SourceFile {
    /** How many characters of a line a message quotes; made by a guest, it may be all of a file. */
    private static final int LONGEST_EXCERPT = 80;

    private final String path;
    private final String text;
    private int @Nullable [] lineStarts;

    public SourceFile(String path, String text) {
        this.path = path;
        this.text = text;
    }

    /** The path as the user wrote it, with forward slashes. */
    public String path() {
        return path;
    }

    public String text() {
        return text;
    }

    /** The position of an offset; an offset past the end is the end. */
    public Position position(int offset) {
        int[] starts = lineStarts();
        int found = Arrays.binarySearch(starts, offset);
        int line = found >= 0 ? found : -found - 2;
        return new Position(line + 1, offset - starts[line] + 1);
    }

    /** The text of a line (from 1) without its line break. */
    public String line(int line) {
        return text.substring(lineStart(line), lineEnd(line));
    }

    /** What a message quotes of a line (from 1); of a long one the beginning. */
    public String excerpt(int line) {
        String all = line(line).strip();
        if (all.length() <= LONGEST_EXCERPT) {
            return all;
        }
        boolean isSplit = Character.isHighSurrogate(all.charAt(LONGEST_EXCERPT - 1));
        return all.substring(0, LONGEST_EXCERPT - (isSplit ? 1 : 0)) + "...";
    }

    /** The offset at which a line (from 1) ends, in front of its line break. */
    public int lineEnd(int line) {
        int[] starts = lineStarts();
        int start = starts[line - 1];
        int end = line < starts.length ? starts[line] : text.length();
        while (end > start && isLineBreak(text.charAt(end - 1))) {
            end--;
        }
        return end;
    }

    /** The offset at which a line (from 1) begins. */
    public int lineStart(int line) {
        return lineStarts()[line - 1];
    }

    public int lineCount() {
        return lineStarts().length;
    }

    public Span span(int start, int end) {
        return new Span(this, start, end);
    }

    private int[] lineStarts() {
        if (lineStarts == null) {
            lineStarts = computeLineStarts();
        }
        return lineStarts;
    }

    private int[] computeLineStarts() {
        int[] starts = new int[16];
        int count = 1;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            boolean carriageReturnOfPair =
                    c == '\r' && i + 1 < text.length() && text.charAt(i + 1) == '\n';
            if (isLineBreak(c) && !carriageReturnOfPair) {
                if (count == starts.length) {
                    starts = Arrays.copyOf(starts, count * 2);
                }
                starts[count++] = i + 1;
            }
        }
        return Arrays.copyOf(starts, count);
    }

    private static boolean isLineBreak(char c) {
        return c == '\n' || c == '\r';
    }

    @Override
    public String toString() {
        return path;
    }
}
