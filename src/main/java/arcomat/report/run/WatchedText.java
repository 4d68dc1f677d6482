package arcomat.report.run;

import arcomat.model.Trace;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;
import arcomat.report.text.Snippet;
import arcomat.report.text.Style;
import arcomat.simulate.watch.Watch.Violation;
import arcomat.simulate.watch.Watching.Watched;
import arcomat.source.Severity;

import java.util.List;

/** What became of the requirements that a run was watched for, line by line. */
public final class WatchedText {
    private WatchedText() {}

    /** Below a trace; empty where nothing was watched for. */
    public static String render(Trace trace, List<Watched> watched, Style style) {
        StringBuilder out = new StringBuilder(watched.isEmpty() ? "" : "\n");
        String unit = TraceColumns.of(trace).unit();
        watched.forEach(each -> out.append(render(each, unit, style)));
        return out.toString();
    }

    private static String render(Watched watched, String unit, Style style) {
        if (watched.violation().isPresent()) {
            Violation violation = watched.violation().get();
            return style.error("violated")
                    + ": "
                    + Printable.escape(violation.message())
                    + "\n  "
                    + FindingsText.place(violation.requirement().span())
                    + "\n"
                    + Snippet.render(violation.requirement().span(), Severity.WARNING, style);
        }
        String requirement = Printable.escape(watched.requirement());
        if (watched.unknown().isPresent()) {
            return style.warning("unknown")
                    + ": "
                    + requirement
                    + ": "
                    + watched.unknown().get()
                    + "\n";
        }
        String nothing =
                watched.nothingFrom().isPresent()
                        ? ", but promises nothing from "
                                + unit
                                + " "
                                + watched.nothingFrom().getAsInt()
                                + " on"
                        : "";
        return style.good("kept") + ": " + requirement + nothing + "\n";
    }
}
