package arcomat.campaign.against;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignResult;
import arcomat.campaign.Row;
import arcomat.campaign.Trials;

import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * The table of a campaign that has come to its end.
 *
 * @param name for people: where it is kept
 * @param campaign what it asks
 * @param result what it came to
 * @param hash what tells it from any other
 * @param rows all of them, in the order of their numbers; to be closed
 */
public record FinishedTable(
        String name,
        Campaign campaign,
        CampaignResult result,
        String hash,
        Supplier<Stream<Row>> rows) {
    /** How many rows it has. */
    public long runs() {
        return result.made() + result.impossible() + result.givenUp();
    }

    /** How many it could have. */
    public long planned() {
        return Trials.of(campaign).count();
    }

    /**
     * Whether it ended as soon as its answer was clear: then how many rows there are depends on
     * what they say, and no test that supposes a number of runs holds.
     */
    public boolean endedEarly() {
        return runs() < planned();
    }
}
