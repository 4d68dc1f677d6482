package arcomat.cli.command.watch;

import arcomat.pipeline.watch.Listener.Done;
import arcomat.pipeline.watch.WatchStatus.Step;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Printable;

import java.util.Collection;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;

/** The words for what happens while somebody watches. */
final class StepNames {
    private static final int NAMED = 3;

    private StepNames() {}

    /** As wide as the widest, with a blank behind. */
    static String of(Step step) {
        return String.format(Locale.ROOT, "%-7s", step.name().toLowerCase(Locale.ROOT));
    }

    /** {@code 3 files in 12 ms}. */
    static String work(Done done) {
        String noun =
                switch (done.step()) {
                    case CHECK -> "file";
                    case TEST -> "suite";
                    case VERIFY -> "promise";
                    case WORLD -> "world";
                };
        long millis = TimeUnit.NANOSECONDS.toMillis(done.nanos());
        return FindingsText.count(done.subjects(), noun) + " in " + millis + " ms";
    }

    /** {@code saved: p/Robot.arc}, or some of many. */
    static String changed(Collection<String> files) {
        int more = files.size() - NAMED;
        return "saved: "
                + files.stream()
                        .limit(NAMED)
                        .map(Printable::escape)
                        .collect(Collectors.joining(", "))
                + (more > 0 ? " and " + more + " more" : "");
    }
}
