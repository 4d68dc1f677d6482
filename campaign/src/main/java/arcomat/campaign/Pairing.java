package arcomat.campaign;

import arcomat.campaign.statistics.Decision;
import arcomat.campaign.statistics.McNemar;

import org.jspecify.annotations.Nullable;

import java.util.Optional;

/** Pairs of runs that differ in what is compared, and in nothing else. */
public final class Pairing {
    private final Optional<Campaign.Comparison> comparison;
    private final EventPairs pairs;
    private @Nullable Row first;

    public Pairing(Campaign campaign) {
        this.comparison = campaign.comparison();
        String event = comparison.map(Campaign.Comparison::event).orElse("");
        int column = comparison.isPresent() ? campaign.column(event) : -1;
        this.pairs = new EventPairs(event, column, column);
    }

    /** The next row. */
    public void see(Row row) {
        if (comparison.isEmpty()) {
            return;
        }
        if (row.trial().number() % 2 == 0) {
            first = row;
        } else if (first != null) {
            pairs.see(first, row);
        }
    }

    /** Empty where nothing is compared. */
    public Optional<ChangedPairs> changes() {
        return comparison.map(asked -> pairs.changes());
    }

    private static String onSeeds(McNemar test, ChangedPairs changes) {
        return test.better() + test.worse() < changes.better() + changes.worse()
                ? "; on the whole %,d seeds got better and %,d worse"
                        .formatted(test.better(), test.worse())
                : "";
    }

    Optional<Judgement> judge() {
        return comparison.map(this::judge);
    }

    private Judgement judge(Campaign.Comparison asked) {
        McNemar test = pairs.test();
        ChangedPairs changes = pairs.changes();
        Decision decision = test.decision(1 - asked.confidence());
        String word =
                switch (decision) {
                    case HOLDS -> "the new one is better";
                    case FAILS -> "the new one is worse";
                    case UNDECIDED -> "no difference is shown";
                };
        String because =
                "%s: of %,d pairs %,d got better and %,d worse%s"
                        .formatted(
                                word,
                                changes.pairs(),
                                changes.better(),
                                changes.worse(),
                                onSeeds(test, changes));
        String subject =
                "%s by %s at %s"
                        .formatted(
                                asked.parameter(),
                                asked.event(),
                                Figure.percent(asked.confidence()));
        return new Judgement(subject, false, decision, because, asked.place());
    }
}
