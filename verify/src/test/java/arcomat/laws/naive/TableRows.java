package arcomat.laws.naive;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * The rows of a table as a reader of its text sees them, who knows of no automata. Each stands on a
 * line of its own, and cells are messages, or several behind {@code alt}.
 *
 * @param columns those of the inputs
 * @param rows the cells below them
 */
public record TableRows(List<String> columns, List<List<String>> rows) {
    public TableRows {
        columns = List.copyOf(columns);
        rows = rows.stream().map(List::copyOf).toList();
    }

    /** Of the only table in a text. */
    public static TableRows of(String text) {
        List<String> columns = new ArrayList<>();
        List<List<String>> rows = new ArrayList<>();
        for (String line : text.lines().map(String::strip).toList()) {
            if (line.startsWith("in ")) {
                columns.addAll(List.of(line.substring(3, line.length() - 1).split(", ")));
            } else if (line.startsWith("|")) {
                String cells = line.substring(1, line.indexOf("=>"));
                rows.add(Arrays.stream(cells.split("\\|")).map(String::strip).toList());
            }
        }
        return new TableRows(columns, rows);
    }

    /**
     * The row that decides, if one does.
     *
     * @param messages by the names of the inputs; those that carry nothing are not in it
     */
    public Optional<Integer> deciding(Map<String, String> messages) {
        return IntStream.range(0, rows.size())
                .filter(row -> fits(rows.get(row), messages))
                .boxed()
                .findFirst();
    }

    private boolean fits(List<String> cells, Map<String, String> messages) {
        return IntStream.range(0, columns.size())
                .allMatch(
                        i -> fits(cells.get(i), Optional.ofNullable(messages.get(columns.get(i)))));
    }

    private static boolean fits(String cell, Optional<String> message) {
        return switch (cell) {
            case "*" -> true;
            case "--" -> message.isEmpty();
            case "?" -> message.isPresent();
            default -> message.isPresent() && messages(cell).contains(message.get());
        };
    }

    private static List<String> messages(String cell) {
        return cell.startsWith("alt {")
                ? List.of(cell.substring(5, cell.length() - 1).split(", "))
                : List.of(cell);
    }
}
