package arcomat.campaign.against;

import arcomat.campaign.CampaignResult.Occurrence;
import arcomat.campaign.CampaignResult.Spread;
import arcomat.campaign.ChangedPairs;
import arcomat.campaign.statistics.Decision;

import java.util.List;

/**
 * How two tables differ that ask the same.
 *
 * @param pairs runs that both have: the same seed and the same values
 * @param isPaired whether these decide; else, where they are less than half of the smaller table,
 *     intervals do
 * @param events that both ask about
 * @param measures likewise
 * @param others names of columns that are not compared: they do not mean the same in both
 */
public record TableDifference(
        long pairs,
        boolean isPaired,
        List<OfEvent> events,
        List<OfMeasure> measures,
        List<String> others) {
    public TableDifference {
        events = List.copyOf(events);
        measures = List.copyOf(measures);
        others = List.copyOf(others);
    }

    /**
     * Of an event.
     *
     * @param changes in the pairs
     * @param decision holds if the new table is better, fails if it is worse
     */
    public record OfEvent(
            Occurrence before, Occurrence now, ChangedPairs changes, Decision decision) {}

    /**
     * Of a measure. Whether more is better, nobody has said.
     *
     * @param greater pairs in which the number is greater in the new table
     * @param smaller pairs in which it is smaller there
     * @param differs whether that is more than chance
     */
    public record OfMeasure(
            Spread before, Spread now, long greater, long smaller, boolean differs) {}

    /** Whether something is worse than before. */
    public boolean isWorse() {
        return events.stream().anyMatch(each -> each.decision() == Decision.FAILS);
    }
}
