package arcomat.campaign;

import arcomat.campaign.Variation.Choice;
import arcomat.campaign.statistics.Sampling;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The runs of a campaign by their numbers: a function of the campaign's text and nothing else.
 * Where two words are compared, run 2n has the first and run 2n + 1 the second, and everything else
 * is the same.
 */
public final class Trials {
    private final Campaign campaign;
    private final List<Variation> drawn;
    private final long points;
    private final int repeated;

    private Trials(Campaign campaign, List<Variation> drawn, long points, int repeated) {
        this.campaign = campaign;
        this.drawn = drawn;
        this.points = points;
        this.repeated = repeated;
    }

    public static Trials of(Campaign campaign) {
        List<Variation> drawn =
                campaign.variations().stream().filter(each -> !isCompared(campaign, each)).toList();
        return campaign.plan()
                .match(
                        random -> new Trials(campaign, drawn, random.runs(), 1),
                        latin -> new Trials(campaign, drawn, latin.runs(), 1),
                        grid -> new Trials(campaign, drawn, size(drawn, grid), grid.seeds()));
    }

    private static boolean isCompared(Campaign campaign, Variation variation) {
        return campaign.comparison()
                .filter(each -> each.parameter().equals(variation.parameter()))
                .isPresent();
    }

    private static long size(List<Variation> drawn, Plan.Grid grid) {
        long points = 1;
        for (Variation each : drawn) {
            points = Math.multiplyExact(points, (long) each.steps(grid.steps()).size());
        }
        return points;
    }

    /** How many there are. */
    public long count() {
        return points * repeated * variants();
    }

    private int variants() {
        return campaign.comparison().isPresent() ? 2 : 1;
    }

    /**
     * A run.
     *
     * @param number from 0, less than {@link #count}
     */
    public Trial trial(long number) {
        long alike = number / variants();
        long point = alike / repeated;
        // All points of a grid have the same seeds: what differs between them is not chance.
        long seed = campaign.firstSeed() + (repeated > 1 ? alike % repeated : point);
        Map<String, String> values = new LinkedHashMap<>();
        List<String> coordinates = coordinates(point);
        for (Variation each : campaign.variations()) {
            values.put(each.parameter(), "");
        }
        for (int i = 0; i < drawn.size(); i++) {
            values.put(drawn.get(i).parameter(), coordinates.get(i));
        }
        campaign.comparison()
                .ifPresent(
                        each ->
                                values.put(
                                        each.parameter(),
                                        compared(each).words().get((int) (number % 2))));
        return new Trial(number, seed, values);
    }

    private Choice compared(Campaign.Comparison comparison) {
        return campaign.variations().stream()
                .filter(each -> each.parameter().equals(comparison.parameter()))
                .map(each -> each.domain().match(range -> new Choice(List.of()), choice -> choice))
                .findFirst()
                .orElseThrow();
    }

    private List<String> coordinates(long point) {
        return campaign.plan()
                .match(
                        random -> drawn(i -> Sampling.random(campaign.firstSeed(), point, i)),
                        latin -> drawn(i -> Sampling.latin(campaign.firstSeed(), point, i, points)),
                        grid -> ofGrid(point, grid.steps()));
    }

    private List<String> drawn(java.util.function.IntToDoubleFunction share) {
        List<String> values = new ArrayList<>();
        for (int i = 0; i < drawn.size(); i++) {
            values.add(drawn.get(i).domain().at(share.applyAsDouble(i)));
        }
        return values;
    }

    /** The last parameter changes fastest. */
    private List<String> ofGrid(long point, int steps) {
        List<String> values = new ArrayList<>();
        long rest = point;
        for (int i = drawn.size() - 1; i >= 0; i--) {
            List<String> all = drawn.get(i).steps(steps);
            values.add(0, all.get((int) (rest % all.size())));
            rest /= all.size();
        }
        return values;
    }
}
