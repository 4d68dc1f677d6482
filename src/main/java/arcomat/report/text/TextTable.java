package arcomat.report.text;

import java.util.ArrayList;
import java.util.List;

/** Columns of text, aligned at the left; the first column at the right, if it holds numbers. */
public final class TextTable {
    private static final String GAP = "  ";

    private final List<String> headings;
    private final List<List<String>> rows = new ArrayList<>();

    public TextTable(List<String> headings) {
        this.headings = headings;
    }

    /** Cells beyond the last one given are empty. */
    public void add(List<String> cells) {
        rows.add(cells);
    }

    /** As many lines as the longest column has, but one at least; with texts of models. */
    public void addColumns(List<List<String>> columns) {
        int lines = Math.max(1, columns.stream().mapToInt(List::size).max().orElse(0));
        for (int i = 0; i < lines; i++) {
            int line = i;
            add(columns.stream().map(column -> cell(column, line)).toList());
        }
    }

    private static String cell(List<String> column, int line) {
        return line < column.size() ? Printable.escape(column.get(line)) : "";
    }

    public String render(Style style) {
        int[] widths = widths();
        boolean numbered = isNumbered();
        StringBuilder out = new StringBuilder();
        out.append(style.strong(line(headings, widths, numbered))).append('\n');
        List<String> rules = new ArrayList<>();
        for (int width : widths) {
            rules.add("-".repeat(width));
        }
        out.append(style.quiet(line(rules, widths, numbered))).append('\n');
        for (List<String> row : rows) {
            out.append(line(row, widths, numbered)).append('\n');
        }
        return out.toString();
    }

    private int[] widths() {
        int[] widths = new int[headings.size()];
        for (int i = 0; i < widths.length; i++) {
            widths[i] = headings.get(i).length();
            for (List<String> row : rows) {
                if (i < row.size()) {
                    widths[i] = Math.max(widths[i], row.get(i).length());
                }
            }
        }
        return widths;
    }

    private boolean isNumbered() {
        return rows.stream().allMatch(row -> row.get(0).matches("[0-9.]*"));
    }

    private static String line(List<String> cells, int[] widths, boolean numbered) {
        StringBuilder line = new StringBuilder();
        for (int i = 0; i < cells.size(); i++) {
            String blanks = " ".repeat(widths[i] - cells.get(i).length());
            line.append(i == 0 ? "" : GAP)
                    .append(i == 0 && numbered ? blanks + cells.get(i) : cells.get(i) + blanks);
        }
        return line.toString().stripTrailing();
    }
}
