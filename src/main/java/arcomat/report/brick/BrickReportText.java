package arcomat.report.brick;

import arcomat.brick.BrickReport;
import arcomat.brick.Origin;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;

import java.util.List;

/** For people: what a robot's jar is made of, and how full the brick will be. */
public final class BrickReportText {
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
        return table.render(style) + NeedsText.render(report.needs());
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
}
