package arcomat.report.text;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Columns of text, aligned at the left; the first column at the right, if it holds numbers. */
public final class TextTable {
    private final List<String> headings;
    private final List<List<String>> rows = new ArrayList<>();

    @SuppressWarnings("NullAway.Init") // arranged before anything is written
    private TableLayout layout;

    public TextTable(List<String> headings) {
        this.headings = headings;
    }

    /** Cells beyond the last one given are empty. */
    public void add(List<String> cells) {
        rows.add(cells);
    }

    /** As {@link #rows} makes of columns. */
    public void addColumns(List<List<String>> columns) {
        rows(columns).forEach(this::add);
    }

    /** As many rows as the longest column has, but one at least; with texts of models. */
    public static List<List<String>> rows(List<List<String>> columns) {
        int rows = Math.max(1, columns.stream().mapToInt(List::size).max().orElse(0));
        return IntStream.range(0, rows)
                .mapToObj(row -> columns.stream().map(column -> cell(column, row)).toList())
                .toList();
    }

    private static String cell(List<String> column, int line) {
        return line < column.size() ? Printable.escape(column.get(line)) : "";
    }

    public String render(Style style) {
        arrange(style);
        return headings(style) + body();
    }

    private void arrange(Style style) {
        List<List<String>> all = new ArrayList<>(rows.size() + 1);
        all.add(headings);
        all.addAll(rows);
        layout = TableLayout.of(all, style.width(), isNumbered());
    }

    private String headings(Style style) {
        StringBuilder out = new StringBuilder();
        layout.lines(headings).forEach(line -> out.append(style.strong(line)).append('\n'));
        return out.append(style.quiet(layout.rule())).append('\n').toString();
    }

    private String body() {
        return rows.stream().map(this::more).collect(Collectors.joining());
    }

    /**
     * The table as far as it goes now. More rows follow one by one, in columns that are as wide as
     * now: nobody has seen those rows yet.
     *
     * @param first width of the first column at least
     */
    public String begin(Style style, int first) {
        arrange(style);
        layout = layout.withFirst(first);
        String begun = headings(style) + body();
        rows.clear();
        return begun;
    }

    /** One more row of a table that has begun. */
    public String more(List<String> cells) {
        StringBuilder out = new StringBuilder();
        layout.lines(cells).forEach(line -> out.append(line).append('\n'));
        return out.toString();
    }

    private boolean isNumbered() {
        return rows.stream().allMatch(row -> row.get(0).matches("[0-9.]*"));
    }
}
