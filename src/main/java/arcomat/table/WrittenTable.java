package arcomat.table;

import java.util.ArrayList;
import java.util.List;

/**
 * The text of a table, taken apart: what its clauses name, and what stands between the bars of its
 * rows. Its syntax is right, or nobody would ask.
 */
record WrittenTable(List<Part> inputs, List<Part> outputs, List<Row> rows) {
    WrittenTable {
        inputs = List.copyOf(inputs);
        outputs = List.copyOf(outputs);
        rows = List.copyOf(rows);
    }

    /**
     * {@code | a | b | => | c |;}.
     *
     * @param end behind the semicolon
     */
    record Row(int start, int end, List<Part> inputs, List<Part> outputs) {
        Row {
            inputs = List.copyOf(inputs);
            outputs = List.copyOf(outputs);
        }
    }

    static WrittenTable of(String text) {
        Part all = Part.of(text);
        List<Part> inputs = List.of();
        List<Part> outputs = List.of();
        List<Row> rows = new ArrayList<>();
        int next = 0;
        for (Part clause : all.split(";")) {
            next += clause.tokens().size() + 1;
            if (clause.beginsWith("in")) {
                inputs = clause.behind(1).split(",");
            } else if (clause.beginsWith("out")) {
                outputs = clause.behind(1).split(",");
            } else {
                rows.add(row(clause, all.tokens().get(next - 1).end()));
            }
        }
        return new WrittenTable(inputs, outputs, rows);
    }

    private static Row row(Part clause, int end) {
        List<Part> sides = clause.split("=>");
        return new Row(clause.start(), end, sides.get(0).split("|"), sides.get(1).split("|"));
    }
}
