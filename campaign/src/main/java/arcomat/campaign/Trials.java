package arcomat.campaign;

import arcomat.campaign.Variation.Choice;
import arcomat.campaign.statistics.Sampling;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntToDoubleFunction;

/**
 * The runs of a campaign by their numbers: a function of the campaign's text and nothing else.
 * Where two words are compared, run 2n has the first and run 2n + 1 the second, and everything else
 * is the same.
 */
public final class Trials {
    private final Campaign campaign;
    private final List<Variation> drawn;
    private final List<List<String>> steps;
    private final long points;
    private final int repeated;

    /**
     * @param steps of a grid, the values of each that is drawn; else none
     */
    private Trials(
            Campaign campaign,
            List<Variation> drawn,
            List<List<String>> steps,
            long points,
            int repeated) {
        this.campaign = campaign;
        this.drawn = drawn;
        this.steps = steps;
        this.points = points;
        this.repeated = repeated;
    }

    public static Trials of(Campaign campaign) {
        List<Variation> drawn =
                campaign.variations().stream().filter(each -> !isCompared(campaign, each)).toList();
        return campaign.plan()
                .match(
                        random -> new Trials(campaign, drawn, List.of(), random.runs(), 1),
                        latin -> new Trials(campaign, drawn, List.of(), latin.runs(), 1),
                        grid -> ofGrid(campaign, drawn, grid));
    }

    private static boolean isCompared(Campaign campaign, Variation variation) {
        return campaign.comparison()
                .filter(each -> each.parameter().equals(variation.parameter()))
                .isPresent();
    }

    private static Trials ofGrid(Campaign campaign, List<Variation> drawn, Plan.Grid grid) {
        List<List<String>> steps = drawn.stream().map(each -> each.steps(grid.steps())).toList();
        long points = 1;
        for (List<String> each : steps) {
            points = Math.multiplyExact(points, (long) each.size());
        }
        return new Trials(campaign, drawn, steps, points, grid.seeds());
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
        long point = alike % points;
        // Common random numbers: what differs between the points of a grid is not chance. All
        // points have a seed before any has the next one, so that what shares it is together.
        long turn = campaign.plan().match(random -> alike, latin -> alike, grid -> alike / points);
        long seed = campaign.firstSeed() + turn;
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
                        grid -> ofGrid(point));
    }

    private List<String> drawn(IntToDoubleFunction share) {
        List<String> values = new ArrayList<>();
        for (int i = 0; i < drawn.size(); i++) {
            values.add(drawn.get(i).domain().at(share.applyAsDouble(i)));
        }
        return values;
    }

    /** The last parameter changes fastest. */
    private List<String> ofGrid(long point) {
        List<String> values = new ArrayList<>();
        long rest = point;
        for (int i = steps.size() - 1; i >= 0; i--) {
            List<String> all = steps.get(i);
            values.add(0, all.get((int) (rest % all.size())));
            rest /= all.size();
        }
        return values;
    }
}
