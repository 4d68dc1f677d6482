package arcomat.campaign;

import java.util.List;

/**
 * What the second of two words that are compared has changed.
 *
 * @param pairs of which it is known what the first run did
 * @param better pairs in which only the second run was good
 * @param worse pairs in which only the first one was
 * @param firstBetter the first ones that got better
 * @param firstWorse the first ones that got worse
 */
public record ChangedPairs(
        long pairs, long better, long worse, List<Pair> firstBetter, List<Pair> firstWorse) {
    public ChangedPairs {
        firstBetter = List.copyOf(firstBetter);
        firstWorse = List.copyOf(firstWorse);
    }

    /** Two runs that differ in what is compared. */
    public record Pair(Row before, Row after) {}
}
