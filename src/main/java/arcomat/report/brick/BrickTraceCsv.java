package arcomat.report.brick;

import arcomat.report.text.CsvLine;
import arcomat.sim.trace.Trace;

import java.util.ArrayList;
import java.util.List;

/** A program's run with one line per cycle, for spreadsheets. */
public final class BrickTraceCsv {
    private static final String OTHER = "other";

    private BrickTraceCsv() {}

    public static String render(Trace trace) {
        BrickRows all = BrickRows.of(trace);
        List<String> headings = new ArrayList<>(all.headings());
        headings.set(headings.size() - 1, OTHER);
        StringBuilder out = new StringBuilder(CsvLine.of(headings));
        all.rows().forEach(row -> out.append(CsvLine.of(all.cells(row))));
        return out.toString();
    }
}
