package arcomat.table;

import arcomat.guest.Meaning;
import arcomat.guest.SituatedLanguage;
import arcomat.guest.Vicinity;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;

/**
 * I/O tables, {@code table { in a; out b; | x | => | y |; }}: an automaton with one state and a
 * transition for each row. The first row that fits decides.
 */
public final class Tables implements SituatedLanguage {
    /** ARC0335: a row of an I/O table has one cell for each column. */
    private static final String WIDTH = "ARC0335";

    /** ARC0316: each message of an item has the type of its port or variable. */
    private static final String TYPE_OF_ITEM = "ARC0316";

    @Override
    public String keyword() {
        return "table";
    }

    @Override
    public List<String> codes() {
        return List.of(TableColumns.CODE, WIDTH, RowMeaning.CODE);
    }

    @Override
    public void translate(Written table, Vicinity around, Meaning meaning) {
        WrittenTable text = WrittenTable.of(table.text());
        TableColumns columns = new TableColumns(table, around);
        List<TableColumn> inputs = columns.of(text.inputs(), Vicinity.Kind.INPUT, meaning);
        List<TableColumn> outputs = columns.of(text.outputs(), Vicinity.Kind.OUTPUT, meaning);
        meaning.stands().tell(TYPE_OF_ITEM, RowMeaning.CODE);
        meaning.write(table.whole(), "state table; initial table;");
        for (int i = 0; i < text.rows().size(); i++) {
            WrittenTable.Row row = text.rows().get(i);
            Span place = table.part(row.start(), row.end());
            if (hasWidth(row, place, inputs, outputs, meaning)) {
                meaning.element(place).turn(i);
                new RowMeaning(table, meaning).write(row, inputs, outputs);
            }
        }
    }

    private static boolean hasWidth(
            WrittenTable.Row row,
            Span place,
            List<TableColumn> inputs,
            List<TableColumn> outputs,
            Meaning meaning) {
        List<String> wrong = new ArrayList<>();
        compare("input", inputs.size(), row.inputs().size(), wrong);
        compare("output", outputs.size(), row.outputs().size(), wrong);
        if (!wrong.isEmpty()) {
            meaning.problem(
                    WIDTH,
                    place,
                    "the row has "
                            + String.join(" and ", wrong)
                            + "; give each column one cell, '*' where an input does not matter and"
                            + " '--' where nothing is sent");
        }
        return wrong.isEmpty();
    }

    private static void compare(String side, int columns, int cells, List<String> wrong) {
        if (columns != cells) {
            wrong.add(count(cells, side + " cell") + " for " + count(columns, side + " column"));
        }
    }

    private static String count(int number, String thing) {
        return number + " " + thing + (number == 1 ? "" : "s");
    }
}
