package arcomat.check.behaviour.item;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.TableSymbol;
import arcomat.tree.IoTable;

import java.util.ArrayList;
import java.util.List;

/** ARC0335: a row of an I/O table has one cell for each column. */
public final class TableRowWidth implements Check.OnTable {

    @Override
    public void check(TableSymbol table, Context context, Findings findings) {
        IoTable node = table.node();
        for (IoTable.Row row : node.rows()) {
            List<String> wrong = new ArrayList<>();
            compare("input", node.inputs().size(), row.inputs().size(), wrong);
            compare("output", node.outputs().size(), row.outputs().size(), wrong);
            if (!wrong.isEmpty()) {
                findings.report(
                        row,
                        "the row has %s; give each column one cell, '*' where an input does not"
                                + " matter and '--' where nothing is sent",
                        String.join(" and ", wrong));
            }
        }
    }

    private static void compare(String side, int columns, int cells, List<String> wrong) {
        if (cells != columns) {
            wrong.add(
                    Wording.count(cells, side + " cell")
                            + " for "
                            + Wording.count(columns, side + " column"));
        }
    }
}
