package arcomat.report.brick;

import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;
import arcomat.sim.trace.Trace;

import java.util.List;

/** A program's run as a table: the cycles in which something changes. */
public final class BrickTraceText {
    private BrickTraceText() {}

    public static String render(Trace trace, Style style) {
        BrickRows all = BrickRows.of(trace);
        TextTable table = new TextTable(all.headings());
        BrickRows.Row before = null;
        for (BrickRows.Row row : all.rows()) {
            if (before == null || row.differsFrom(before)) {
                List<String> cells = all.cells(row).stream().map(Printable::escape).toList();
                table.add(cells);
            }
            before = row;
        }
        return table.render(style);
    }
}
