package arcomat.campaign;

import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A campaign as its text describes it.
 *
 * @param world path of the world's file, relative to the campaign's
 * @param measures columns of its own
 * @param watches events of its own: what single robots see
 * @param jointWatches events of its own: what several robots do together
 * @param firstSeed of the first run; each further one has the next, but all points of a grid have
 *     the same
 * @param stopsWhenDecided whether it may end before its last run, as soon as every requirement on a
 *     probability is decided
 */
public record Campaign(
        World world,
        List<Variation> variations,
        List<Measure> measures,
        List<Watched> watches,
        List<JointWatch> jointWatches,
        Plan plan,
        long firstSeed,
        boolean stopsWhenDecided,
        List<Demand> demands,
        Optional<Comparison> comparison,
        Optional<Search> search,
        Optional<Split> split) {
    public Campaign {
        variations = List.copyOf(variations);
        measures = List.copyOf(measures);
        watches = List.copyOf(watches);
        jointWatches = List.copyOf(jointWatches);
        demands = List.copyOf(demands);
    }

    /**
     * The world that it is about.
     *
     * @param place where the campaign names it
     */
    public record World(String file, Span place) {}

    /**
     * Two words of one parameter, tried on the same seeds.
     *
     * @param parameter its first word is what there was, its second what is new
     * @param event that is asked about: the fewer the better, but for the goal
     * @param confidence from 0 to 1: how sure one has to be that the new one is worse
     */
    public record Comparison(String parameter, String event, double confidence, Span place) {}

    /**
     * A search for the worst case.
     *
     * @param side below: the smallest value is the worst
     * @param measure a column of numbers
     * @param runs how many runs it may take
     */
    public record Search(Demand.Side side, String measure, int runs, Span place) {}

    /**
     * A rare event that is approached by levels.
     *
     * @param measure the distance that has to become small: {@code distance} or {@code clearance}
     * @param levels in mm, falling; the event is to come to the last one
     * @param runs of each level
     */
    public record Split(String measure, List<Integer> levels, int runs, Span place) {
        public Split {
            levels = List.copyOf(levels);
        }

        /** The names of the columns that say when levels were reached. */
        List<String> columns() {
            return levels.stream().map(level -> "within_" + level).toList();
        }
    }

    /**
     * How many seeds so many runs have: points of a grid share them, and so do two words that are
     * compared. Runs of different seeds are independent of each other; those of one are not.
     */
    public long seeds(long runs) {
        int words = comparison.isPresent() ? 2 : 1;
        return plan.match(
                random -> runs / words,
                latin -> runs / words,
                grid -> Math.min(runs / words, grid.seeds()));
    }

    /** What every row of the table answers. */
    public List<Column> columns() {
        List<Column> columns = new ArrayList<>(Column.builtIn());
        measures.forEach(each -> columns.add(each.column()));
        watches.forEach(each -> columns.add(each.column()));
        jointWatches.forEach(each -> columns.add(each.column()));
        split.ifPresent(each -> columns.addAll(Column.within(each)));
        return columns;
    }

    /** The place of a column in a row. */
    public int column(String name) {
        List<Column> columns = columns();
        for (int i = 0; i < columns.size(); i++) {
            if (columns.get(i).name().equals(name)) {
                return i;
            }
        }
        throw new IllegalArgumentException(name);
    }
}
