package arcomat.report.run;

import arcomat.model.Trace;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.simulate.watch.Watch.Violation;
import arcomat.simulate.watch.Watching.Watched;
import arcomat.source.Span;

import java.util.List;
import java.util.stream.Collectors;

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
            Span place = violation.requirement().span();
            String message = Printable.escape(violation.message());
            return style.error("violated")
                    + ": "
                    + message
                    + "\n"
                    + FindingsText.placed(place, style);
        }
        String requirement = Printable.escape(watched.requirement());
        if (watched.unknown().isPresent()) {
            String why = watched.unknown().get();
            return style.warning("unknown") + ": " + requirement + ": " + why + "\n";
        }
        String nothing =
                watched.nothingFrom().stream()
                        .mapToObj(
                                from -> ", but promises nothing from " + unit + " " + from + " on")
                        .collect(Collectors.joining());
        return style.good("kept") + ": " + requirement + nothing + "\n";
    }
}
