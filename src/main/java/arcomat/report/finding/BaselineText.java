package arcomat.report.finding;

import arcomat.report.finding.Baseline.Entry;
import arcomat.report.text.OneLine;
import arcomat.report.text.Printable;
import arcomat.report.text.Style;

import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Baselines as a file: a line for each entry, sorted, so that versions of it compare well. */
public final class BaselineText {
    private static final String FIRST = "arcomat baseline 1";
    private static final Pattern ENTRY =
            Pattern.compile(
                    "([A-Z]+[0-9]{4}) ([0-9a-f]{16}) ([1-9][0-9]{0,8}) (.+)", Pattern.DOTALL);

    private BaselineText() {}

    public static String render(Baseline baseline) {
        StringBuilder out = new StringBuilder(FIRST + "\n# code, fingerprint, how often, file\n");
        for (Map.Entry<Entry, Integer> each : baseline.entries().entrySet()) {
            Entry entry = each.getKey();
            String path = OneLine.of(entry.path());
            out.append(
                    String.join(
                            " ", entry.code(), entry.fingerprint(), "" + each.getValue(), path));
            out.append('\n');
        }
        return out.toString();
    }

    /**
     * Reads a baseline.
     *
     * @throws Damaged where the text is none
     */
    public static Baseline parse(String text) throws Damaged {
        List<String> lines = text.lines().toList();
        if (lines.isEmpty() || !lines.get(0).equals(FIRST)) {
            throw new Damaged("its first line is not '" + FIRST + "'");
        }
        SortedMap<Entry, Integer> entries = new TreeMap<>();
        for (int i = 1; i < lines.size(); i++) {
            String line = lines.get(i);
            if (line.isBlank() || line.startsWith("#")) {
                continue;
            }
            Matcher parts = ENTRY.matcher(line);
            if (!parts.matches()) {
                throw new Damaged("line " + (i + 1) + " is no entry");
            }
            Entry entry = new Entry(OneLine.read(parts.group(4)), parts.group(1), parts.group(2));
            entries.merge(entry, Integer.parseInt(parts.group(3)), Integer::sum);
        }
        return new Baseline(entries);
    }

    /** A text that is no baseline, and why. */
    public static final class Damaged extends Exception {
        private static final long serialVersionUID = 1L;

        Damaged(String reason) {
            super(reason);
        }
    }

    /** Entries that are gone, as lines; empty where there are none. */
    public static String gone(SortedMap<Entry, Integer> gone, Style style) {
        if (gone.isEmpty()) {
            return "";
        }
        long number = gone.values().stream().mapToLong(Integer::longValue).sum();
        String headline =
                "%s of the baseline %s gone; --write-baseline forgets:\n"
                        .formatted(
                                FindingsText.count(number, "finding"), number == 1 ? "is" : "are");
        StringBuilder out = new StringBuilder(style.good(headline));
        gone.forEach((entry, times) -> out.append(gone(entry, times)));
        return out.toString();
    }

    private static String gone(Entry entry, int times) {
        String path = Printable.escape(entry.path());
        return "  %s %s%s\n"
                .formatted(entry.code(), path, times == 1 ? "" : ", " + times + " times");
    }
}
