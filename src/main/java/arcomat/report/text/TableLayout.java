package arcomat.report.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * How wide the columns of a table are. Where lines end at a border, columns are made narrower until
 * they fit, so that all of them need about the same number of lines, and cells are broken.
 *
 * @param border how many characters a line may have
 * @param numbered whether the first column stands at the right
 */
record TableLayout(int[] widths, int border, boolean numbered) {
    private static final String GAP = "  ";

    /** As many rows tell how wide columns are. */
    private static final int ROWS = 1000;

    /** Words up to this length are not broken, if there is room. */
    private static final int LONG_WORD = 12;

    /** A column of fewer characters cannot be read. */
    private static final int NARROWEST = 6;

    static TableLayout of(List<List<String>> rows, int width, boolean numbered) {
        int[] natural = natural(rows);
        long free = width - (long) GAP.length() * (natural.length - 1);
        return new TableLayout(
                Arrays.stream(natural).asLongStream().sum() <= free
                        ? natural
                        : fitting(natural, rows, (int) free),
                width,
                numbered);
    }

    private static int[] natural(List<List<String>> rows) {
        return IntStream.range(0, rows.get(0).size())
                .map(i -> rows.stream().mapToInt(row -> cell(row, i).length()).max().orElse(0))
                .toArray();
    }

    private static String cell(List<String> row, int column) {
        return column < row.size() ? row.get(column) : "";
    }

    /** The first column is a number or a name that is looked for: it keeps its width. */
    private static int[] fitting(int[] natural, List<List<String>> rows, int free) {
        List<List<String>> sample = rows.subList(0, Math.min(rows.size(), ROWS));
        int[] widths = new int[natural.length];
        for (int i = 0; i < widths.length; i++) {
            widths[i] = i == 0 ? natural[0] : longestWord(i, sample);
        }
        shrink(widths, natural, free);
        for (int rest = free - Arrays.stream(widths).sum(); rest > 0; rest--) {
            widths[tallest(widths, natural, sample)]++;
        }
        return widths;
    }

    private static int longestWord(int column, List<List<String>> rows) {
        int longest =
                rows.stream()
                        .flatMap(row -> Stream.of(cell(row, column).split(" ")))
                        .mapToInt(String::length)
                        .max()
                        .orElse(0);
        return Math.max(1, Math.min(longest, LONG_WORD));
    }

    /** Takes from the widest columns until they fit, or until nothing can be read any more. */
    private static void shrink(int[] widths, int[] natural, int free) {
        while (Arrays.stream(widths).sum() > free) {
            int widest = 1;
            for (int i = 2; i < widths.length; i++) {
                widest = widths[i] > widths[widest] ? i : widest;
            }
            if (widths.length == 1 || widths[widest] <= Math.min(natural[widest], NARROWEST)) {
                return;
            }
            widths[widest]--;
        }
    }

    /** The column that would have the most lines, of those that can be wider. */
    private static int tallest(int[] widths, int[] natural, List<List<String>> rows) {
        int tallest = widths.length - 1;
        long most = -1;
        for (int i = 0; i < widths.length; i++) {
            long lines = widths[i] < natural[i] ? lines(i, widths[i], rows) : -1;
            if (lines > most) {
                most = lines;
                tallest = i;
            }
        }
        return tallest;
    }

    private static long lines(int column, int width, List<List<String>> rows) {
        return rows.stream()
                .mapToLong(row -> (cell(row, column).length() + width - 1) / width)
                .sum();
    }

    /** The same with a first column of some width at least. */
    TableLayout withFirst(int width) {
        int[] wider = widths.clone();
        wider[0] = Math.max(width, wider[0]);
        return new TableLayout(wider, border, numbered);
    }

    /** A row as one line, or as several. */
    List<String> lines(List<String> cells) {
        List<List<String>> parts = new ArrayList<>();
        for (int i = 0; i < cells.size(); i++) {
            boolean last = i == widths.length - 1;
            parts.add(broken(cells.get(i), last ? Math.max(widths[i], toTheBorder()) : widths[i]));
        }
        int height = parts.stream().mapToInt(List::size).max().orElse(1);
        return IntStream.range(0, height).mapToObj(line -> line(parts, line)).toList();
    }

    /** The room of the last column, and what is left behind it. */
    private int toTheBorder() {
        int gaps = (widths.length - 1) * GAP.length();
        return border - gaps - Arrays.stream(widths, 0, widths.length - 1).sum();
    }

    /** A line below the headings. */
    String rule() {
        return line(Arrays.stream(widths).mapToObj("-"::repeat).map(List::of).toList(), 0);
    }

    private String line(List<List<String>> parts, int number) {
        StringBuilder line = new StringBuilder();
        for (int i = 0; i < parts.size(); i++) {
            String cell = cell(parts.get(i), number);
            String blanks = " ".repeat(Math.max(0, widths[i] - cell.length()));
            line.append(i == 0 ? "" : GAP)
                    .append(i == 0 && numbered ? blanks + cell : cell + blanks);
        }
        return line.toString().stripTrailing();
    }

    /** At blanks; what has none, behind a sign if there is one, or anywhere. */
    private static List<String> broken(String cell, int width) {
        if (cell.length() <= width) {
            return Collections.singletonList(cell);
        }
        List<String> parts = new ArrayList<>();
        String rest = cell;
        while (rest.length() > width) {
            int end = end(rest, width);
            parts.add(rest.substring(0, end).stripTrailing());
            rest = rest.substring(end).stripLeading();
        }
        if (!rest.isEmpty()) {
            parts.add(rest);
        }
        return parts;
    }

    private static int end(String text, int width) {
        int blank = text.lastIndexOf(' ', width);
        if (blank > 0 && !text.substring(0, blank).isBlank()) {
            return blank;
        }
        for (int end = width; end > width / 2; end--) {
            if (!Character.isLetterOrDigit(text.charAt(end - 1))) {
                return end;
            }
        }
        return Character.isHighSurrogate(text.charAt(width - 1)) && width > 1 ? width - 1 : width;
    }
}
