package arcomat.table;

import arcomat.guest.BehaviourLanguage.Written;
import arcomat.guest.Meaning;
import arcomat.source.Span;

import java.util.List;
import java.util.function.Predicate;

/**
 * Says what rows mean: each is a transition.
 *
 * @param meaning takes it, and what is wrong with cells
 */
record RowMeaning(Written table, Meaning meaning) {
    /** ARC0336: a cell of a table has the type of its column and a form that its side allows. */
    static final String CODE = "ARC0336";

    /**
     * @param row with a cell for each column
     */
    void write(WrittenTable.Row row, List<TableColumn> inputs, List<TableColumn> outputs) {
        Span place = table.part(row.start(), row.end());
        meaning.write(place, "table -> table");
        block(place, " {", inputs, " == ", row.inputs(), this::isAsked);
        block(place, " / {", outputs, " = ", row.outputs(), this::isSent);
        meaning.write(place, ";");
    }

    /**
     * One side of the row.
     *
     * @param isItem whether a cell says something that can be looked at
     */
    private void block(
            Span place,
            String open,
            List<TableColumn> columns,
            String relation,
            List<Part> cells,
            Predicate<Part> isItem) {
        String before = open;
        for (int i = 0; i < columns.size(); i++) {
            Part cell = cells.get(i);
            if (columns.get(i).isPort() && isItem.test(cell)) {
                Span name = columns.get(i).place();
                Span value = place(cell);
                meaning.write(place, before).write(name, name.text());
                meaning.write(place, relation).write(value, value.text());
                before = ", ";
            }
        }
        if (!before.equals(open)) {
            meaning.write(place, "}");
        }
    }

    private boolean isAsked(Part cell) {
        return isOneMessage(cell) && !cell.isAnything();
    }

    private boolean isSent(Part cell) {
        if (!isOneMessage(cell)) {
            return false;
        }
        if (cell.isAlternatives()) {
            String message = "an output cell sends one message; 'alt' is for input cells";
            meaning.problem(CODE, place(cell), message);
            return false;
        }
        if (cell.isAnything()) {
            String message =
                    "'*' is for input cells; write the message that is sent, or '--' for none";
            meaning.problem(CODE, place(cell), message);
            return false;
        }
        return true;
    }

    private boolean isOneMessage(Part cell) {
        boolean isList = cell.isList();
        if (isList) {
            meaning.problem(CODE, place(cell), "a cell is about one message; write a single one");
        }
        return !isList;
    }

    private Span place(Part part) {
        return table.part(part.start(), part.end());
    }
}
