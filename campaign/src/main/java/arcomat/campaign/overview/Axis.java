package arcomat.campaign.overview;

import arcomat.campaign.Plan;
import arcomat.campaign.Variation;
import arcomat.campaign.Variation.Choice;
import arcomat.campaign.Variation.Range;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;

/** The values of a parameter in at most {@link #MOST} places, so that they can be drawn. */
public final class Axis {
    static final int MOST = 20;

    /** Runs that a place has on the average; fewer say nothing, and a map of them is noise. */
    private static final double RUNS_PER_CELL = 20;

    private static final int LEAST = 4;

    private final String parameter;
    private final List<String> labels;
    private final ToIntFunction<String> places;

    private Axis(String parameter, List<String> labels, ToIntFunction<String> places) {
        this.parameter = parameter;
        this.labels = List.copyOf(labels);
        this.places = places;
    }

    /** For a map in one direction only: everything is in one place. */
    static Axis none() {
        return new Axis("", List.of(""), value -> 0);
    }

    /**
     * @param runs how many there are: the more, the finer
     */
    static Axis of(Variation variation, Plan plan, long runs) {
        return variation
                .domain()
                .match(
                        range -> ofRange(variation, range, plan, runs),
                        choice -> ofWords(variation.parameter(), choice));
    }

    private static Axis ofRange(Variation variation, Range range, Plan plan, long runs) {
        double numbers = range.high() - range.low() + 1;
        int steps = plan.match(random -> 0, latin -> 0, Plan.Grid::steps);
        if (steps > 0 && steps <= MOST) {
            return ofSteps(variation.parameter(), variation.steps(steps));
        }
        if (range.whole() && numbers <= MOST) {
            return ofSteps(variation.parameter(), variation.steps((int) numbers));
        }
        int most = (int) Math.max(LEAST, Math.min(MOST, Math.sqrt(runs / RUNS_PER_CELL)));
        return ofParts(variation.parameter(), range, parts(range.high() - range.low(), most));
    }

    /** As many as there may be, or somewhat fewer that begin at numbers with two digits. */
    private static int parts(double length, int most) {
        for (int parts = most; 2 * parts >= most && parts >= LEAST; parts--) {
            if (Scale.isShort(length / parts)) {
                return parts;
            }
        }
        return most;
    }

    private static Axis ofSteps(String parameter, List<String> steps) {
        Map<String, Integer> places = new HashMap<>();
        steps.forEach(step -> places.put(step, places.size()));
        return new Axis(parameter, steps, value -> places.getOrDefault(value, 0));
    }

    private static Axis ofWords(String parameter, Choice choice) {
        if (choice.words().size() <= MOST) {
            return ofSteps(parameter, choice.words());
        }
        List<String> first = choice.words().subList(0, MOST - 1);
        List<String> labels = new java.util.ArrayList<>(first);
        labels.add("others");
        Map<String, Integer> places = new HashMap<>();
        first.forEach(word -> places.put(word, places.size()));
        return new Axis(parameter, labels, value -> places.getOrDefault(value, MOST - 1));
    }

    private static Axis ofParts(String parameter, Range range, int parts) {
        double width = (range.high() - range.low()) / parts;
        List<String> labels =
                IntStream.range(0, parts)
                        .mapToObj(
                                part ->
                                        Scale.number(range.low() + part * width)
                                                + " to "
                                                + Scale.number(range.low() + (part + 1) * width))
                        .toList();
        return new Axis(
                parameter,
                width > 0 ? labels : labels.subList(0, 1),
                value ->
                        width > 0
                                ? place(Double.parseDouble(value), range.low(), width, parts)
                                : 0);
    }

    private static int place(double value, double low, double width, int parts) {
        return (int) Math.max(0, Math.min(parts - 1, Math.floor((value - low) / width)));
    }

    /** Its name in the world; empty where there is none. */
    public String parameter() {
        return parameter;
    }

    /** A text for each place. */
    public List<String> labels() {
        return labels;
    }

    int place(String value) {
        return places.applyAsInt(value);
    }
}
