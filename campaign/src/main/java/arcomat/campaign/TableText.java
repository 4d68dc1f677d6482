package arcomat.campaign;

import arcomat.campaign.coverage.ReachedItems;
import arcomat.world.Seeds;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Rows as comma-separated values (RFC 4180): number, seed, values of the parameters, how the run
 * ended, answers, what it has covered. Nothing in it depends on who made the run, or when.
 */
public final class TableText {
    private static final List<String> FIRST = List.of("run", "seed");
    private static final String ENDING = "ending";

    /** The column of {@link ReachedItems}. */
    public static final String TAKEN = "taken";

    /** Columns that are neither a parameter nor an answer. */
    static final List<String> NAMES =
            Stream.concat(FIRST.stream(), Stream.of(ENDING, TAKEN)).toList();

    private final Campaign campaign;
    private final List<Column> columns;

    public TableText(Campaign campaign) {
        this.campaign = campaign;
        this.columns = campaign.columns(); // asked once, and not for each cell of a million rows
    }

    /** The line of names, without its end. */
    public String header() {
        return Stream.of(
                        FIRST.stream(),
                        campaign.variations().stream().map(this::column),
                        Stream.of(ENDING),
                        columns.stream().map(Column::name),
                        Stream.of(TAKEN))
                .flatMap(names -> names)
                .map(TableText::quoted)
                .collect(Collectors.joining(","));
    }

    /** The column of a parameter: its name, told apart where another column is called so. */
    public String column(Variation variation) {
        String name = variation.parameter();
        boolean taken =
                NAMES.contains(name) || columns.stream().anyMatch(each -> each.name().equals(name));
        return taken ? "parameter " + name : name;
    }

    /** The line of a row, without its end. */
    public String line(Row row) {
        List<String> cells = new ArrayList<>();
        cells.add(Long.toString(row.trial().number()));
        cells.add(row.trial().seeds().text());
        cells.addAll(row.trial().values().values());
        cells.add(ending(row));
        for (int i = 0; i < columns.size(); i++) {
            cells.add(row.wasMade() ? number(row.answer(i)) : "");
        }
        cells.add(row.reached().text());
        return cells.stream().map(TableText::quoted).collect(Collectors.joining(","));
    }

    /** How a run ended, and why there are no answers where there are none. */
    public static String ending(Row row) {
        String word = row.ending().word();
        return row.wasMade() ? word : word + ": " + row.remark();
    }

    /** Whole numbers without a fraction; what is none is empty. */
    private static String number(double answer) {
        if (Double.isNaN(answer)) {
            return "";
        }
        return answer == Math.rint(answer) && Math.abs(answer) < 1e15
                ? Long.toString((long) answer)
                : Double.toString(answer);
    }

    private static String quoted(String cell) {
        boolean plain = cell.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
        return plain ? cell : '"' + cell.replace("\"", "\"\"") + '"';
    }

    /**
     * The row of a line that {@link #line} has made.
     *
     * @throws IllegalArgumentException where it is no such line
     */
    public Row row(String line) {
        List<String> cells = cells(line);
        int ending = FIRST.size() + campaign.variations().size();
        if (cells.size() != ending + 1 + columns.size() + 1) {
            throw new IllegalArgumentException(cells.size() + " cells");
        }
        Map<String, String> values = new LinkedHashMap<>();
        for (int i = 0; i < campaign.variations().size(); i++) {
            values.put(campaign.variations().get(i).parameter(), cells.get(FIRST.size() + i));
        }
        Trial trial = new Trial(Long.parseLong(cells.get(0)), Seeds.parse(cells.get(1)), values);
        Row.Ending how = Row.Ending.of(cells.get(ending));
        if (how != Row.Ending.MADE) {
            return Row.withoutAnswers(
                    trial, how, cells.get(ending).substring(how.word().length() + 2));
        }
        List<Double> answers = new ArrayList<>();
        cells.subList(ending + 1, cells.size() - 1)
                .forEach(cell -> answers.add(cell.isEmpty() ? Double.NaN : Double.valueOf(cell)));
        return Row.made(trial, answers, new ReachedItems(cells.get(cells.size() - 1)));
    }

    private static List<String> cells(String line) {
        List<String> cells = new ArrayList<>();
        StringBuilder cell = new StringBuilder();
        boolean inside = false;
        for (int i = 0; i < line.length(); i++) {
            char c = line.charAt(i);
            if (c == '"' && inside && i + 1 < line.length() && line.charAt(i + 1) == '"') {
                cell.append(c);
                i++;
            } else if (c == '"') {
                inside = !inside;
            } else if (c == ',' && !inside) {
                cells.add(cell.toString());
                cell.setLength(0);
            } else {
                cell.append(c);
            }
        }
        cells.add(cell.toString());
        return cells;
    }
}
