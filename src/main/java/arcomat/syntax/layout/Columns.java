package arcomat.syntax.layout;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Pads the cells of a table so that its bars stand below each other. */
final class Columns {
    private Columns() {}

    static void align(List<Line> lines) {
        Map<Object, List<Line>> tables = new HashMap<>();
        for (Line line : lines) {
            if (line.table != null) {
                tables.computeIfAbsent(line.table, t -> new ArrayList<>()).add(line);
            }
        }
        tables.values().forEach(Columns::alignRows);
    }

    private static void alignRows(List<Line> rows) {
        List<Integer> widths = new ArrayList<>();
        for (Line row : rows) {
            List<String> cells = cells(row);
            for (int i = 0; i < cells.size(); i++) {
                if (i == widths.size()) {
                    widths.add(0);
                }
                widths.set(i, Math.max(widths.get(i), cells.get(i).length()));
            }
        }
        for (Line row : rows) {
            if (row.pieces.stream().noneMatch(Line.Piece::breakBefore)) {
                pad(row, cells(row), widths);
            }
        }
    }

    /** The texts up to each bar, the bar included. */
    private static List<String> cells(Line row) {
        List<String> cells = new ArrayList<>();
        StringBuilder cell = new StringBuilder();
        for (Line.Piece piece : row.pieces) {
            cell.append(piece.space() ? " " : "").append(piece.text());
            if (piece.column()) {
                cells.add(cell.toString());
                cell = new StringBuilder();
            }
        }
        return cells;
    }

    private static void pad(Line row, List<String> cells, List<Integer> widths) {
        int cell = 0;
        for (int i = 0; i < row.pieces.size(); i++) {
            Line.Piece piece = row.pieces.get(i);
            if (piece.column()) {
                String padding = " ".repeat(widths.get(cell) - cells.get(cell).length());
                row.pieces.set(
                        i, new Line.Piece(padding + piece.text(), piece.space(), -1, false, true));
                cell++;
            }
        }
    }
}
