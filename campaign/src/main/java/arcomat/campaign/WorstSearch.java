package arcomat.campaign;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What a search for the worst case has come to.
 *
 * @param search what was looked for
 * @param course generation by generation, or several of them together where there are many
 * @param worst the first of the worst runs; absent where no run has such a number
 * @param searches how often it began somewhere else, the first time included
 */
public record WorstSearch(
        Campaign.Search search, List<Step> course, Optional<Found> worst, int searches) {
    /** So many steps are kept at most, an even number: a page draws them. */
    private static final int MOST = 200;

    public WorstSearch {
        course = List.copyOf(course);
    }

    /**
     * The worst of the runs that were made, and not of all that there could be.
     *
     * @param value its number
     */
    public record Found(Row row, double value) {}

    /**
     * A part of the course.
     *
     * @param generations how many of them
     * @param runs that were made in it
     * @param unknown of them without such a number: they may have been worse
     * @param worst number of all of them; absent where there is none
     */
    public record Step(int generations, int runs, int unknown, Optional<Double> worst) {
        private Step and(Step next, Demand.Side side) {
            Optional<Double> both =
                    worst.flatMap(one -> next.worst.map(other -> worse(one, other, side)));
            return new Step(
                    generations + next.generations,
                    runs + next.runs,
                    unknown + next.unknown,
                    both.or(() -> worst).or(next::worst));
        }
    }

    private static double worse(double one, double other, Demand.Side side) {
        return side == Demand.Side.BELOW ? Math.min(one, other) : Math.max(one, other);
    }

    /**
     * The course with one more generation. Of very many, pairs of steps become one: all steps but
     * the last have as many generations.
     */
    public static List<Step> with(List<Step> course, Step next, Demand.Side side) {
        List<Step> longer = new ArrayList<>(course);
        int last = course.size() - 1;
        if (last > 0 && course.get(last).generations() < course.get(0).generations()) {
            longer.set(last, course.get(last).and(next, side));
            return longer;
        }
        if (course.size() == MOST) {
            longer = inPairs(course, side);
        }
        longer.add(next);
        return longer;
    }

    private static List<Step> inPairs(List<Step> course, Demand.Side side) {
        List<Step> pairs = new ArrayList<>();
        for (int i = 0; i + 1 < course.size(); i += 2) {
            pairs.add(course.get(i).and(course.get(i + 1), side));
        }
        return pairs;
    }

    /** How many runs were made. */
    public int runs() {
        return course.stream().mapToInt(Step::runs).sum();
    }

    /** How many of them have no such number. */
    public int unknown() {
        return course.stream().mapToInt(Step::unknown).sum();
    }

    /** As the campaign says it: smallest or largest. */
    public String which() {
        return search.side() == Demand.Side.BELOW ? "smallest" : "largest";
    }
}
