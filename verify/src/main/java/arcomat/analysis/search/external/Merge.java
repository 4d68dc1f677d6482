package arcomat.analysis.search.external;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;

/** Goes through sorted records of several sources in one order; what is equal, source by source. */
final class Merge implements Cursor {
    private record Source(Cursor cursor, int number) {}

    private final PriorityQueue<Source> open;
    private final List<Source> fresh = new ArrayList<>();

    /**
     * @param words the first words of a record by which they are sorted
     */
    Merge(List<Cursor> sources, int words) {
        open =
                new PriorityQueue<>(
                        Math.max(1, sources.size()),
                        ((Comparator<Source>)
                                        (one, other) ->
                                                Cursor.compare(one.cursor, other.cursor, words))
                                .thenComparingInt(Source::number));
        sources.forEach(cursor -> fresh.add(new Source(cursor, fresh.size())));
    }

    static Cursor of(List<Records> runs, int words) {
        return new Merge(runs.stream().map(run -> run.from(0)).toList(), words);
    }

    @Override
    public boolean next() {
        if (!open.isEmpty()) {
            fresh.add(open.poll());
        }
        for (Source source : fresh) {
            if (source.cursor.next()) {
                open.add(source);
            }
        }
        fresh.clear();
        return !open.isEmpty();
    }

    @Override
    public long word(int which) {
        return open.element().cursor.word(which);
    }
}
