package arcomat.syntax.layout;

import java.util.List;

/** From lines to text: blank lines, columns of tables, breaking. */
final class Printing {
    private Printing() {}

    static String print(List<Line> lines) {
        Columns.align(lines);
        StringBuilder text = new StringBuilder();
        Line before = null;
        for (Line line : lines) {
            if (before != null && isBlankBetween(before, line)) {
                text.append('\n');
            }
            text.append(Wrapping.wrap(line)).append('\n');
            before = line;
        }
        return text.toString();
    }

    private static boolean isBlankBetween(Line before, Line line) {
        if (before.opensBody || line.closesBody) {
            return false;
        }
        return line.blankBefore || before.isPackage || before.isImport && !line.isImport;
    }
}
