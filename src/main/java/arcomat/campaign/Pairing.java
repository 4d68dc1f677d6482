package arcomat.campaign;

import arcomat.campaign.statistics.Decision;
import arcomat.campaign.statistics.McNemar;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Pairs of runs that differ in what is compared, and in nothing else. What nobody knows of a run
 * with the second word counts against that word; where it is the first one's, the pair says
 * nothing.
 */
public final class Pairing {
    /** So many of either kind are kept, to be looked at. */
    private static final int KEPT = 20;

    private final Optional<Campaign.Comparison> comparison;
    private final int column;
    private @Nullable Row first;
    private final List<ChangedPairs.Pair> better = new ArrayList<>();
    private final List<ChangedPairs.Pair> worse = new ArrayList<>();
    private long pairs;
    private long betterPairs;
    private long worsePairs;
    private final SeedPairs seeds = new SeedPairs();

    public Pairing(Campaign campaign) {
        this.comparison = campaign.comparison();
        this.column = comparison.map(each -> campaign.column(each.event())).orElse(-1);
    }

    /** The next row. */
    public void see(Row row) {
        if (comparison.isEmpty()) {
            return;
        }
        if (row.trial().number() % 2 == 0) {
            first = row;
        } else if (first != null
                && first.answers(column)
                && row.ending() != Row.Ending.IMPOSSIBLE) {
            pairs++;
            boolean before = isGood(first);
            boolean after = isGood(row);
            ChangedPairs.Pair pair = new ChangedPairs.Pair(first, row);
            if (after && !before) {
                betterPairs++;
                keep(pair, better);
                seeds.add(row.trial().seed(), 1);
            } else if (before && !after) {
                worsePairs++;
                keep(pair, worse);
                seeds.add(row.trial().seed(), -1);
            }
        }
    }

    private static void keep(ChangedPairs.Pair pair, List<ChangedPairs.Pair> kept) {
        if (kept.size() < KEPT) {
            kept.add(pair);
        }
    }

    /** Empty where nothing is compared. */
    public Optional<ChangedPairs> changes() {
        return comparison.map(
                asked -> new ChangedPairs(pairs, betterPairs, worsePairs, better, worse));
    }

    /** What should happen is the goal; everything else should not. */
    private boolean isGood(Row row) {
        boolean wanted = comparison.orElseThrow().event().equals(Quantity.GOAL.word());
        return row.answers(column) && row.happened(column) == wanted;
    }

    private String onSeeds(McNemar test) {
        return test.better() + test.worse() < betterPairs + worsePairs
                ? "; on the whole %,d seeds got better and %,d worse"
                        .formatted(test.better(), test.worse())
                : "";
    }

    Optional<Judgement> judge() {
        return comparison.map(this::judge);
    }

    private Judgement judge(Campaign.Comparison asked) {
        McNemar test = seeds.test();
        double error = 1 - asked.confidence();
        Decision decision = Decision.UNDECIDED;
        String word = "no difference is shown";
        if (test.worsening() <= error) {
            decision = Decision.FAILS;
            word = "the new one is worse";
        } else if (test.improvement() <= error) {
            decision = Decision.HOLDS;
            word = "the new one is better";
        }
        String because =
                "%s: of %,d pairs %,d got better and %,d worse%s"
                        .formatted(word, pairs, betterPairs, worsePairs, onSeeds(test));
        String subject =
                "%s by %s at %s"
                        .formatted(
                                asked.parameter(),
                                asked.event(),
                                Figure.percent(asked.confidence()));
        return new Judgement(subject, false, decision, because, asked.place());
    }
}
