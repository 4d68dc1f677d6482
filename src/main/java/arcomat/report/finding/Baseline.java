package arcomat.report.finding;

import arcomat.source.Diagnostic;
import arcomat.source.Sha256;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.UnaryOperator;

/**
 * Findings that an old project lives with: how often each is known. An entry knows the text of its
 * place, not the line, so that it stays when lines above come and go.
 */
public record Baseline(SortedMap<Entry, Integer> entries) {
    private static final int FINGERPRINT = 16;

    public Baseline {
        entries = java.util.Collections.unmodifiableSortedMap(new TreeMap<>(entries));
    }

    /**
     * Findings that nothing tells apart.
     *
     * @param path of the file, as seen from the baseline
     * @param fingerprint of the text of the place
     */
    public record Entry(String path, String code, String fingerprint) implements Comparable<Entry> {
        private static final Comparator<Entry> ORDER =
                Comparator.comparing(Entry::path)
                        .thenComparing(Entry::code)
                        .thenComparing(Entry::fingerprint);

        /** The same, with the path as seen from elsewhere. */
        public Entry at(String otherPath) {
            return new Entry(otherPath, code, fingerprint);
        }

        @Override
        public int compareTo(Entry other) {
            return ORDER.compare(this, other);
        }
    }

    /**
     * What is new against a baseline.
     *
     * @param gone entries that nothing was found for, with how many findings less there are
     */
    public record Comparison(
            List<Diagnostic> fresh, List<Diagnostic> known, SortedMap<Entry, Integer> gone) {}

    /**
     * @param paths turns a path into one as seen from the baseline
     */
    public static Baseline of(List<Diagnostic> findings, UnaryOperator<String> paths) {
        SortedMap<Entry, Integer> entries = new TreeMap<>();
        findings.forEach(finding -> entries.merge(entry(finding, paths), 1, Integer::sum));
        return new Baseline(entries);
    }

    /** Of findings that nothing tells apart, the first in the file are the known ones. */
    public Comparison compare(List<Diagnostic> findings, UnaryOperator<String> paths) {
        Map<Entry, Integer> open = new TreeMap<>(entries);
        List<Diagnostic> fresh = new ArrayList<>();
        List<Diagnostic> known = new ArrayList<>();
        for (Diagnostic finding : findings) {
            Entry entry = entry(finding, paths);
            int left = open.getOrDefault(entry, 0);
            open.put(entry, left - 1);
            (left > 0 ? known : fresh).add(finding);
        }
        SortedMap<Entry, Integer> gone = new TreeMap<>(open);
        gone.values().removeIf(left -> left <= 0);
        return new Comparison(fresh, known, gone);
    }

    private static Entry entry(Diagnostic finding, UnaryOperator<String> paths) {
        Span place = finding.span();
        return new Entry(paths.apply(place.file().path()), finding.code(), fingerprint(place));
    }

    /**
     * Of the text of a place, however that is laid out. The first line stands for many: what is
     * wrong with a component is so whatever is changed inside. An empty place is known by its line.
     */
    static String fingerprint(Span place) {
        String own = normal(place.firstLine().text());
        String line = place.file().line(place.startPosition().line());
        String text = own.isEmpty() ? normal(line) : own;
        return Sha256.hex(text).substring(0, FINGERPRINT);
    }

    private static String normal(String text) {
        return text.strip().replaceAll("\\s+", " ");
    }
}
