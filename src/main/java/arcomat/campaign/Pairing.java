package arcomat.campaign;

import arcomat.campaign.statistics.Decision;
import arcomat.campaign.statistics.McNemar;

import org.jspecify.annotations.Nullable;

import java.util.Optional;

/** Pairs of runs that differ in what is compared, and in nothing else. */
final class Pairing {
    private final Optional<Campaign.Comparison> comparison;
    private final int column;
    private @Nullable Row first;
    private long pairs;
    private long better;
    private long worse;

    Pairing(Campaign campaign) {
        this.comparison = campaign.comparison();
        this.column = comparison.map(each -> campaign.column(each.event())).orElse(-1);
    }

    void see(Row row) {
        if (comparison.isEmpty()) {
            return;
        }
        if (row.trial().number() % 2 == 0) {
            first = row;
        } else if (first != null && first.wasMade() && row.wasMade()) {
            pairs++;
            boolean before = isGood(first);
            boolean after = isGood(row);
            better += after && !before ? 1 : 0;
            worse += before && !after ? 1 : 0;
        }
    }

    /** What should happen is the goal; everything else should not. */
    private boolean isGood(Row row) {
        boolean wanted = comparison.orElseThrow().event().equals(Quantity.GOAL.word());
        return row.happened(column) == wanted;
    }

    Optional<Judgement> judge() {
        return comparison.map(this::judge);
    }

    private Judgement judge(Campaign.Comparison asked) {
        McNemar test = new McNemar(better, worse);
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
                "%s: of %,d pairs %,d got better and %,d worse"
                        .formatted(word, pairs, better, worse);
        String subject =
                "%s by %s at %s"
                        .formatted(
                                asked.parameter(),
                                asked.event(),
                                Bench.percent(asked.confidence()));
        return new Judgement(subject, false, decision, because);
    }
}
