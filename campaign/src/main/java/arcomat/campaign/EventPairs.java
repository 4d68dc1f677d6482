package arcomat.campaign;

import arcomat.campaign.statistics.McNemar;

import java.util.ArrayList;
import java.util.List;

/**
 * What pairs of runs say about one event. What nobody knows of the second run of a pair counts
 * against it; where it is the first one's, the pair says nothing.
 */
public final class EventPairs {
    /** So many of either kind are kept, to be looked at. */
    private static final int KEPT = 20;

    private final int first;
    private final int second;
    private final boolean isWanted;
    private final List<ChangedPairs.Pair> better = new ArrayList<>();
    private final List<ChangedPairs.Pair> worse = new ArrayList<>();
    private final SeedPairs seeds = new SeedPairs();
    private long pairs;
    private long betterPairs;
    private long worsePairs;

    /**
     * @param event the column's name: what should happen is the goal; everything else should not
     * @param first the place of the column in the first run of each pair
     * @param second its place in the second one
     */
    public EventPairs(String event, int first, int second) {
        this.first = first;
        this.second = second;
        this.isWanted = event.equals(Quantity.GOAL.word());
    }

    /** The next pair; those of one seed come one after the other. */
    public void see(Row before, Row after) {
        if (!before.answers(first) || after.ending() == Row.Ending.IMPOSSIBLE) {
            return;
        }
        pairs++;
        boolean wasGood = before.happened(first) == isWanted;
        boolean isGood = after.answers(second) && after.happened(second) == isWanted;
        ChangedPairs.Pair pair = new ChangedPairs.Pair(before, after);
        if (isGood && !wasGood) {
            betterPairs++;
            keep(pair, better);
            seeds.add(after.trial().seed(), 1);
        } else if (wasGood && !isGood) {
            worsePairs++;
            keep(pair, worse);
            seeds.add(after.trial().seed(), -1);
        }
    }

    private static void keep(ChangedPairs.Pair pair, List<ChangedPairs.Pair> kept) {
        if (kept.size() < KEPT) {
            kept.add(pair);
        }
    }

    public ChangedPairs changes() {
        return new ChangedPairs(pairs, betterPairs, worsePairs, better, worse);
    }

    /** Of the seeds, each of which speaks once. */
    public McNemar test() {
        return seeds.test();
    }
}
