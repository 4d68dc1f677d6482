package arcomat.report.brick;

import arcomat.report.text.OneLine;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;
import arcomat.sim.trace.Lateness;
import arcomat.sim.trace.Trace;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A program's run in text, cycle by cycle. */
public final class BrickTraceText {
    private static final String OTHER = "other";
    private static final double MILLISECOND = 1000;

    private BrickTraceText() {}

    /** A table of the cycles in which something changes. */
    public static String render(Trace trace, Style style) {
        BrickRows all = BrickRows.of(trace);
        TextTable table = new TextTable(all.headings());
        BrickRows.Row before = null;
        for (BrickRows.Row row : all.rows()) {
            if (before == null || row.differsFrom(before)) {
                table.add(all.cells(row).stream().map(Printable::escape).toList());
            }
            before = row;
        }
        return table.render(style);
    }

    /** One line per cycle, for spreadsheets. */
    public static String csv(Trace trace) {
        BrickRows all = BrickRows.of(trace);
        List<String> headings = new ArrayList<>(all.headings());
        headings.set(headings.size() - 1, OTHER);
        StringBuilder out = new StringBuilder(OneLine.csv(headings));
        all.rows().forEach(row -> out.append(OneLine.csv(all.cells(row))));
        return out.toString();
    }

    /**
     * In words, how often a program that has come late did so: {@code 12 slices came late; the
     * longest took 141 ms}.
     */
    public static String of(Lateness lateness) {
        return String.format(
                Locale.ROOT,
                "%d %s came late; the longest took %.1f ms",
                lateness.slices(),
                lateness.slices() == 1 ? "slice" : "slices",
                lateness.longest() / MILLISECOND);
    }
}
