package arcomat.campaign;

import arcomat.campaign.CampaignResult.Occurrence;
import arcomat.campaign.CampaignResult.Spread;
import arcomat.campaign.Row.Ending;
import arcomat.campaign.statistics.Measurements;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/**
 * Looks at the rows of a campaign one after the other, in the order of their numbers. Keeps counts
 * and a few rows: a million runs take it no more memory than a thousand.
 */
public final class Judge {
    private final Campaign campaign;
    private final Map<Ending, Long> endings = new EnumMap<>(Ending.class);
    private final long[] happened;
    private final long[] answered;
    private final List<Bench> benches;
    private final Pairing pairing;
    private final Notable notable;

    public Judge(Campaign campaign) {
        this.campaign = campaign;
        this.happened = new long[campaign.columns().size()];
        this.answered = new long[campaign.columns().size()];
        this.benches = campaign.demands().stream().map(each -> Bench.of(each, campaign)).toList();
        this.pairing = new Pairing(campaign);
        this.notable = new Notable(campaign);
    }

    /** The next row. */
    public void see(Row row) {
        endings.merge(row.ending(), 1L, Long::sum);
        for (int i = 0; i < row.answers().size(); i++) {
            happened[i] += row.happened(i) ? 1 : 0;
            answered[i] += row.answers(i) ? 1 : 0;
        }
        if (row.ending() != Ending.IMPOSSIBLE) {
            benches.forEach(each -> each.see(row));
        }
        pairing.see(row);
        notable.see(row);
    }

    /** Whether the campaign may end before its last run, and nothing more is to be learnt. */
    public boolean isDecided() {
        return campaign.stopsWhenDecided()
                && campaign.comparison().isEmpty()
                && !benches.isEmpty()
                && benches.stream().allMatch(Bench::isDecided);
    }

    /**
     * What all rows come to.
     *
     * @param measured the numbers of a column, of the rows that were made
     */
    public CampaignResult result(Function<String, Measurements> measured) {
        List<Judgement> judgements = new ArrayList<>();
        benches.forEach(each -> judgements.add(each.judge(measured)));
        pairing.judge().ifPresent(judgements::add);
        return new CampaignResult(
                count(Ending.MADE),
                count(Ending.IMPOSSIBLE),
                count(Ending.GIVEN_UP),
                occurrences(),
                spreads(measured),
                judgements,
                notable.rows());
    }

    private long count(Ending ending) {
        return endings.getOrDefault(ending, 0L);
    }

    private List<Occurrence> occurrences() {
        List<Occurrence> occurrences = new ArrayList<>();
        for (int i = 0; i < happened.length; i++) {
            Column column = campaign.columns().get(i);
            if (column.isEvent()) {
                long all = count(Ending.MADE) + count(Ending.GIVEN_UP);
                occurrences.add(
                        new Occurrence(
                                column,
                                happened[i],
                                answered[i],
                                all - answered[i],
                                campaign.seeds(all)));
            }
        }
        return occurrences;
    }

    private List<Spread> spreads(Function<String, Measurements> measured) {
        if (count(Ending.MADE) == 0) {
            return List.of();
        }
        return campaign.columns().stream()
                .filter(column -> !column.isEvent())
                .map(column -> Spread.of(column, measured.apply(column.name())))
                .toList();
    }
}
