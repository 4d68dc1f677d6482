package arcomat.report.text;

/**
 * A source line as a terminal shows it: tabs are expanded, unsafe characters escaped, and each
 * offset of the line has a column, so that an underline stands below what it means.
 */
final class DisplayLine {
    private static final int TAB = 4;

    private final String text;
    private final int[] columns;

    private DisplayLine(String text, int[] columns) {
        this.text = text;
        this.columns = columns;
    }

    static DisplayLine of(String line) {
        StringBuilder shown = new StringBuilder();
        int[] columns = new int[line.length() + 1];
        int column = 0;
        int offset = 0;
        while (offset < line.length()) {
            int c = line.codePointAt(offset);
            String piece = piece(c, column);
            for (int i = 0; i < Character.charCount(c); i++) {
                columns[offset++] = column;
            }
            shown.append(piece);
            column += width(c, piece);
        }
        columns[line.length()] = column;
        return new DisplayLine(shown.toString(), columns);
    }

    private static String piece(int c, int column) {
        if (c == '\t') {
            return " ".repeat(TAB - column % TAB);
        }
        return Printable.escape(new StringBuilder().appendCodePoint(c).toString());
    }

    /** Columns that a character takes on a terminal. */
    private static int width(int c, String piece) {
        if (piece.length() > Character.charCount(c) || c == '\t') {
            return piece.length();
        }
        if (c < 0x300) {
            return 1;
        }
        int type = Character.getType(c);
        if (type == Character.NON_SPACING_MARK || type == Character.ENCLOSING_MARK) {
            return 0;
        }
        return isWide(c) ? 2 : 1;
    }

    /** East Asian wide and full-width characters, and pictographs. */
    private static boolean isWide(int c) {
        return c >= 0x1100 && c <= 0x115F
                || c >= 0x2E80 && c <= 0xA4CF && c != 0x303F
                || c >= 0xAC00 && c <= 0xD7A3
                || c >= 0xF900 && c <= 0xFAFF
                || c >= 0xFE30 && c <= 0xFE6F
                || c >= 0xFF00 && c <= 0xFF60
                || c >= 0xFFE0 && c <= 0xFFE6
                || c >= 0x1F300 && c <= 0x1FAFF
                || c >= 0x20000 && c <= 0x3FFFD;
    }

    String text() {
        return text;
    }

    /** The column, from 0, at which the character at an offset of the line begins. */
    int column(int offset) {
        return columns[Math.min(offset, columns.length - 1)];
    }
}
