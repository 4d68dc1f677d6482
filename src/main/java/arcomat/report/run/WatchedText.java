package arcomat.report.run;

import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;
import arcomat.report.text.Snippet;
import arcomat.report.text.Style;
import arcomat.simulate.Violation;
import arcomat.simulate.Watched;
import arcomat.source.Severity;

import java.util.List;

/** What became of the requirements that a run was watched for, line by line. */
public final class WatchedText {
    private WatchedText() {}

    /** Below a trace; empty where nothing was watched for. */
    public static String render(List<Watched> watched, Style style) {
        StringBuilder out = new StringBuilder(watched.isEmpty() ? "" : "\n");
        watched.forEach(each -> out.append(render(each, style)));
        return out.toString();
    }

    private static String render(Watched watched, Style style) {
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
        String nothing =
                watched.nothingFrom().isPresent()
                        ? ", but promises nothing from slice "
                                + watched.nothingFrom().getAsInt()
                                + " on"
                        : "";
        return style.good("kept") + ": " + Printable.escape(watched.requirement()) + nothing + "\n";
    }
}
