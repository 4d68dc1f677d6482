package arcomat.campaign;

import arcomat.campaign.Campaign.Split;
import arcomat.campaign.statistics.Families;
import arcomat.campaign.statistics.Sampling;
import arcomat.campaign.statistics.Splitting.Level;
import arcomat.world.Physics;
import arcomat.world.Seeds;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/**
 * The runs of a splitting, a level after the other. Those of the first level begin where the world
 * does; each further one draws a run that has reached the level before, does what that one did up
 * to the moment when it came there, and lets another seed draw the errors of sensors from then on.
 * Which runs there are depends on the campaign and on the rows so far, and on nothing else.
 */
public final class SplitCourse {
    private static final double STEPS_PER_SECOND = 1000.0 / Physics.STEP;

    private final Campaign campaign;
    private final Split split;
    private final List<Level> levels;
    private final List<Arrival> arrivals;
    private final Tried tried;

    /**
     * A run that has reached the last level so far.
     *
     * @param family number of the run of the first level that it goes back to
     */
    private record Arrival(Row row, long family) {}

    /**
     * All runs so far.
     *
     * @param nearest the first of those with the smallest distance
     */
    private record Tried(long runs, long givenUp, Optional<Row> nearest) {}

    private SplitCourse(
            Campaign campaign,
            Split split,
            List<Level> levels,
            List<Arrival> arrivals,
            Tried tried) {
        this.campaign = campaign;
        this.split = split;
        this.levels = levels;
        this.arrivals = arrivals;
        this.tried = tried;
    }

    /** Before the first level. */
    public static SplitCourse start(Campaign campaign, Split split) {
        Tried nothing = new Tried(0, 0, Optional.empty());
        return new SplitCourse(campaign, split, List.of(), List.of(), nothing);
    }

    /** Whether there is no further level, or nowhere to start from. */
    public boolean isOver() {
        boolean stuck = tried.runs() > 0 && arrivals.isEmpty();
        return stuck || levels.size() == split.levels().size();
    }

    /** The runs of the next level. */
    public List<Trial> trials() {
        // Behind those of the table, with seeds behind theirs: nothing is drawn twice.
        long first = Trials.of(campaign).count() + tried.runs();
        return LongStream.range(first, first + split.runs()).mapToObj(this::trial).toList();
    }

    private Trial trial(long number) {
        long seed = campaign.firstSeed() + number;
        if (levels.isEmpty()) {
            return new Trial(number, seed, values(number));
        }
        Row parent = parent(number).row();
        double seconds = parent.answer(column(levels.size() - 1));
        long tick = Math.round(seconds * STEPS_PER_SECOND);
        Seeds seeds = parent.trial().seeds().afresh(tick, seed);
        return new Trial(number, seeds, parent.trial().values());
    }

    private Map<String, String> values(long number) {
        Map<String, String> values = new LinkedHashMap<>();
        List<Variation> variations = campaign.variations();
        for (int i = 0; i < variations.size(); i++) {
            double share = Sampling.random(campaign.firstSeed(), number, i);
            values.put(variations.get(i).parameter(), variations.get(i).domain().at(share));
        }
        return values;
    }

    /** Each is as likely as any other, whoever else has drawn it. */
    private Arrival parent(long number) {
        double share = Sampling.random(campaign.firstSeed(), number, 0);
        return arrivals.get((int) (share * arrivals.size()));
    }

    private int column(int level) {
        return campaign.column(split.columns().get(level));
    }

    /**
     * After the next level.
     *
     * @param rows of its runs, in the order of their numbers
     */
    public SplitCourse next(List<Row> rows) {
        List<Row> made = rows.stream().filter(Row::wasMade).toList();
        int column = column(levels.size());
        List<Arrival> reached =
                made.stream()
                        .filter(row -> Double.isFinite(row.answer(column)))
                        .map(row -> new Arrival(row, family(row.trial().number())))
                        .toList();
        List<Level> all = new ArrayList<>(levels);
        if (made.size() > 1) {
            all.add(new Level(made.size(), reached.size()));
        }
        boolean known = made.size() > 1;
        return new SplitCourse(
                campaign, split, List.copyOf(all), known ? reached : List.of(), tried(rows, made));
    }

    private long family(long number) {
        return levels.isEmpty() ? number : parent(number).family();
    }

    private Tried tried(List<Row> rows, List<Row> made) {
        long givenUp = rows.stream().filter(row -> row.ending() == Row.Ending.GIVEN_UP).count();
        int column = campaign.column(split.measure());
        Optional<Row> nearest =
                Stream.concat(tried.nearest().stream(), made.stream())
                        .filter(row -> !Double.isNaN(row.answer(column)))
                        .min(Comparator.comparingDouble(row -> row.answer(column)));
        return new Tried(tried.runs() + rows.size(), tried.givenUp() + givenUp, nearest);
    }

    /** What all runs so far say. */
    public RareEvent result() {
        Map<Long, Long> sizes =
                arrivals.stream()
                        .map(Arrival::family)
                        .collect(Collectors.groupingBy(Function.identity(), Collectors.counting()));
        int column = campaign.column(split.measure());
        return new RareEvent(
                split,
                levels,
                new Families(List.copyOf(sizes.values())),
                tried.runs(),
                tried.givenUp(),
                tried.nearest().map(row -> new RareEvent.Nearest(row, row.answer(column))));
    }
}
