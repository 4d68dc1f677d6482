package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;
import arcomat.report.text.TextTable;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTestResult.Cell;
import arcomat.simulate.test.StreamTestResult.Verdict;

import java.util.List;
import java.util.stream.Collectors;

/**
 * Results of stream tests: a line per test, and below a failing one its streams side by side up to
 * a little behind the first difference.
 */
public final class StreamTestText {
    private static final int SLICES_BEHIND = 2;
    private static final String INDENT = "    ";

    private StreamTestText() {}

    public static String render(List<StreamTestResult> results, Style style) {
        StringBuilder out = new StringBuilder();
        String suite = "";
        for (StreamTestResult result : results) {
            String file = result.test().span().file().path();
            if (!file.equals(suite)) {
                suite = file;
                out.append(style.strong(Printable.escape(file))).append('\n');
            }
            out.append(render(result, style));
        }
        return out.toString();
    }

    private static String render(StreamTestResult result, Style style) {
        String name = " " + Printable.escape(result.test().name());
        return switch (result.verdict()) {
            case PASSED -> "  " + style.good("passed") + name + "\n";
            case VACUOUS ->
                    "  " + style.warning("passed, vacuous") + name + ": " + vacuous(result) + "\n";
            case FAILED -> "  " + style.error("FAILED") + name + failure(result, style) + "\n";
            case UNKNOWN -> "  " + style.warning("unknown") + name + because(result) + "\n";
        };
    }

    private static String because(StreamTestResult result) {
        return ": " + Printable.escape(reason(result));
    }

    /** In a line, for somebody who sees beside it which test it is about. */
    public static String line(StreamTestResult result) {
        return switch (result.verdict()) {
            case PASSED -> "passed";
            case VACUOUS -> "passed, vacuous: " + vacuous(result);
            case FAILED -> "failed: " + reason(result);
            case UNKNOWN -> "unknown: " + reason(result);
        };
    }

    /** From when on a test passes only because anything would. */
    static String vacuous(StreamTestResult result) {
        boolean timed = result.test().component().profile() == Component.Profile.TIME_SYNCHRONOUS;
        String from =
                result.vacuousFrom().stream()
                        .mapToObj(at -> "from " + (timed ? "slice " : "event ") + at + " ")
                        .collect(Collectors.joining());
        return from + result.chaotic() + " promises nothing (chaos)";
    }

    /** In a sentence why a test fails, or why nobody knows. */
    static String reason(StreamTestResult result) {
        if (result.failure().isPresent()) {
            return result.failure().get();
        }
        return result.cells().stream()
                .filter(Cell::differs)
                .findFirst()
                .map(cell -> difference(cell, result.test().component().profile()))
                .orElse("nothing that the model allows is what the test expects");
    }

    private static String difference(Cell cell, Component.Profile profile) {
        boolean timed = profile == Component.Profile.TIME_SYNCHRONOUS;
        return "in %s %d '%s' is %s, expected is %s"
                .formatted(
                        timed ? "slice" : "message",
                        cell.slice(),
                        cell.port(),
                        messages(cell.actual()),
                        messages(cell.expected()));
    }

    private static String failure(StreamTestResult result, Style style) {
        StringBuilder out = new StringBuilder(" (line ");
        out.append(result.test().span().startPosition().line()).append(")\n");
        result.failure()
                .ifPresent(f -> out.append(INDENT).append(Printable.escape(f)).append('\n'));
        String table = sideBySide(result, style);
        for (String line : table.split("\n")) {
            out.append(INDENT).append(line).append('\n');
        }
        return out.toString();
    }

    /** Expected, actual and allowed streams in a table, up to a little behind the difference. */
    static String sideBySide(StreamTestResult result, Style style) {
        int last = result.firstDifference().orElse(Integer.MAX_VALUE - SLICES_BEHIND);
        TextTable table =
                new TextTable(List.of("slice", "port", "expected", "actual", "", "allowed"));
        for (Cell cell : result.cells()) {
            if (cell.slice() <= last + SLICES_BEHIND) {
                table.add(
                        List.of(
                                String.valueOf(cell.slice()),
                                Printable.escape(cell.port()),
                                messages(cell.expected()),
                                messages(cell.actual()),
                                cell.differs() ? "<--" : "",
                                cell.differs() ? allowed(cell) : ""));
            }
        }
        return table.render(style);
    }

    /** {@code --} is silence, as in models. */
    static String messages(List<Value> messages) {
        return messages.isEmpty() ? "--" : Printable.escape(TraceTable.text(messages));
    }

    private static String allowed(Cell cell) {
        return cell.allowed().isEmpty()
                ? "--"
                : Printable.escape(String.join(" or ", cell.allowed()));
    }

    /** One line: {@code 12 passed, 1 failed, 1 unknown}. */
    public static String summary(List<StreamTestResult> results, Style style) {
        long failed = count(results, Verdict.FAILED);
        long vacuous = count(results, Verdict.VACUOUS);
        long unknown = count(results, Verdict.UNKNOWN);
        String text = (results.size() - failed - unknown) + " passed";
        text += vacuous > 0 ? " (" + vacuous + " vacuous)" : "";
        text += ", " + failed + " failed";
        text += unknown > 0 ? ", " + unknown + " unknown" : "";
        if (failed > 0) {
            return style.error(text);
        }
        return unknown > 0 ? style.warning(text) : style.good(text);
    }

    private static long count(List<StreamTestResult> results, Verdict verdict) {
        return results.stream().filter(result -> result.verdict() == verdict).count();
    }
}
