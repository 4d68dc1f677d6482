package arcomat.report.page;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * What one port, state or variable is from step to step, as run lengths.
 *
 * @param group the heading that it stands under
 * @param name unique in its timeline
 * @param before what it is before the first step; empty for nothing
 * @param values all that it ever is
 */
public record Track(
        String group, String name, Kind kind, String before, List<Entry> values, List<Run> runs) {
    /**
     * How the heading of a part begins, before its path: pages fold it, and nest it by the path.
     */
    public static final String PART = "part ";

    /** Nothing: a port that is silent. */
    public static final int NOTHING = -1;

    public Track {
        values = List.copyOf(values);
        runs = List.copyOf(runs);
    }

    /**
     * A track without drawings.
     *
     * @param texts step by step, empty for nothing
     */
    public static Track of(String group, String name, Kind kind, Stream<String> texts) {
        Builder track = new Builder(group, name, kind);
        texts.forEach(track::addUnlessEmpty);
        return track.build();
    }

    /**
     * The same with other steps: each is what it is at the given one, and nothing where that is
     * less than 0.
     */
    public Track at(List<Integer> steps) {
        List<Integer> known = new ArrayList<>();
        runs.forEach(run -> known.addAll(Collections.nCopies(run.length(), run.value())));
        List<Run> others = new ArrayList<>();
        for (int step : steps) {
            int value = step < 0 ? NOTHING : known.get(step);
            int end = others.size() - 1;
            if (end >= 0 && others.get(end).value() == value) {
                others.set(end, new Run(value, others.get(end).length() + 1));
            } else {
                others.add(new Run(value, 1));
            }
        }
        return new Track(group, name, kind, before, values, others);
    }

    /** The same under another heading, by another name. */
    public Track called(String heading, String title) {
        return new Track(heading, title, kind, before, values, runs);
    }

    /** What a track tells of. */
    public enum Kind {
        /** Messages on a port. */
        PORT,
        /** The state of an automaton. */
        STATE,
        VARIABLE,
        /** Why the track above it changed; shown for one step at a time. */
        REASON,
        /** The way through a drawing; shown there only. */
        PATH
    }

    /**
     * A value.
     *
     * @param elements of drawings that stand for it, such as {@code state 2}
     */
    public record Entry(String text, List<String> elements) {
        public Entry {
            elements = List.copyOf(elements);
        }
    }

    /**
     * The same value in several steps.
     *
     * @param value its position among the values, or {@link #NOTHING}
     */
    public record Run(int value, int length) {}

    /** Collects a track step by step. */
    public static final class Builder {
        private final String group;
        private final String name;
        private final Kind kind;
        private final Map<Entry, Integer> values = new LinkedHashMap<>();
        private final List<Run> runs = new ArrayList<>();
        private String before = "";
        private int last = NOTHING;
        private int length;
        private int total;

        public Builder(String group, String name, Kind kind) {
            this.group = group;
            this.name = name;
            this.kind = kind;
        }

        /** What it is before the first step. */
        public Builder startingAs(String text) {
            before = text;
            return this;
        }

        /** How many steps there are so far. */
        public int steps() {
            return total;
        }

        public Builder add(String text) {
            return add(text, List.of());
        }

        /** Nothing, if the text is empty. */
        public Builder addUnlessEmpty(String text) {
            return text.isEmpty() ? addNothing() : add(text);
        }

        public Builder add(String text, List<String> elements) {
            return append(values.computeIfAbsent(new Entry(text, elements), any -> values.size()));
        }

        public Builder addNothing() {
            return append(NOTHING);
        }

        /** Fills up with nothing. */
        public Builder silentUntil(int step) {
            while (total < step) {
                addNothing();
            }
            return this;
        }

        private Builder append(int value) {
            if (value != last) {
                flush();
                last = value;
            }
            length++;
            total++;
            return this;
        }

        private void flush() {
            if (length > 0) {
                runs.add(new Run(last, length));
                length = 0;
            }
        }

        public Track build() {
            flush();
            return new Track(group, name, kind, before, List.copyOf(values.keySet()), runs);
        }
    }
}
