package arcomat.report.brick;

import arcomat.brick.BrickReport;
import arcomat.brick.api.BrickCost;
import arcomat.brick.jar.RobotJar.Origin;
import arcomat.brick.need.Needs;
import arcomat.brick.need.Needs.Need;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;

import java.util.List;
import java.util.Locale;

/** For people: what a robot's jar is made of, and how full the brick will be. */
public final class BrickReportText {
    private static final double THOUSAND = 1000;

    private BrickReportText() {}

    /** A table by origin and what the linked program needs; findings are shown elsewhere. */
    public static String render(BrickReport report, Style style) {
        TextTable table = new TextTable(List.of("classes", "methods", "bytes", "origin"));
        int methods = 0;
        for (BrickReport.Share share : report.shares()) {
            add(table, share.classes(), share.methods(), share.bytes(), name(share.origin()));
            methods += share.methods();
        }
        add(table, report.classes(), methods, report.bytes(), "all");
        return table.render(style) + needs(report.needs());
    }

    /** The same in a few words, for somebody who sees beside them what they are about. */
    public static String line(BrickReport report) {
        Needs needs = report.needs();
        String classes = "jar: " + classes(needs) + " classes";
        String slice =
                needs.slice().amount().isPresent()
                        ? slice(needs) + " a slice"
                        : "slice " + slice(needs);
        return String.join(", ", classes, slice, "memory " + memory(needs.memory()));
    }

    private static void add(TextTable table, int classes, int methods, int bytes, String name) {
        table.add(List.of("" + classes, "" + methods, "" + bytes, name));
    }

    private static String name(Origin origin) {
        return switch (origin) {
            case GENERATED -> "generated from models";
            case RUNTIME -> "runtime of generated code";
            case PLATFORM -> "platform library";
            case HAND_WRITTEN -> "written by hand";
        };
    }

    /** How full the brick will be, a line for each of its limits. */
    private static String needs(Needs needs) {
        return "linked with leJOS: "
                + classes(needs)
                + " classes\nmemory: "
                + memory(needs.memory())
                + "\nlongest slice: "
                + slice(needs)
                + "\n";
    }

    private static String classes(Needs needs) {
        return "%s%d of %d"
                .formatted(needs.isExact() ? "" : "about ", needs.classes(), Needs.MOST_CLASSES);
    }

    private static String memory(Need memory) {
        return memory.amount().isPresent()
                ? String.format(
                        Locale.ROOT,
                        "%s %.1f of %.1f kB",
                        about(memory),
                        memory.amount().getAsLong() / THOUSAND,
                        BrickCost.HEAP_BYTES / THOUSAND)
                : unknown(memory);
    }

    private static String slice(Needs needs) {
        Need slice = needs.slice();
        if (slice.amount().isEmpty()) {
            return unknown(slice);
        }
        String limit = needs.cycle().isPresent() ? " of " + needs.cycle().getAsInt() : "";
        double milliseconds = slice.amount().getAsLong() / THOUSAND;
        return String.format(Locale.ROOT, "%s %.1f%s ms", about(slice), milliseconds, limit);
    }

    private static String about(Need need) {
        return need.isBound() ? "at most" : "about";
    }

    private static String unknown(Need need) {
        return "not known: " + need.unknown().orElseThrow();
    }
}
