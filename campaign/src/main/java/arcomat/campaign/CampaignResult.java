package arcomat.campaign;

import arcomat.campaign.statistics.Confidence;
import arcomat.campaign.statistics.ConfidenceInterval;
import arcomat.campaign.statistics.Decision;
import arcomat.campaign.statistics.Measurements;
import arcomat.campaign.statistics.Proportion;
import arcomat.campaign.statistics.Quantile;

import java.util.List;

/**
 * What the runs of a campaign come to.
 *
 * @param made runs that were made
 * @param impossible runs whose values make no world
 * @param givenUp runs that took too long by the PC's clock
 * @param occurrences how often each event happened, in the order of the columns
 * @param spreads where the numbers of each measure are; none where no run was made
 * @param judgements of the demands in the order of the campaign, then of the comparison
 * @param notable runs that somebody may want to see again, the worst first
 */
public record CampaignResult(
        long made,
        long impossible,
        long givenUp,
        List<Occurrence> occurrences,
        List<Spread> spreads,
        List<Judgement> judgements,
        List<Row> notable) {
    public CampaignResult {
        occurrences = List.copyOf(occurrences);
        spreads = List.copyOf(spreads);
        judgements = List.copyOf(judgements);
        notable = List.copyOf(notable);
    }

    /**
     * How often something happened.
     *
     * @param runs in which it did
     * @param known runs that say whether it did
     * @param unknown runs that were given up, or do not say it
     * @param seeds of all of these runs
     */
    public record Occurrence(Column column, long runs, long known, long unknown, long seeds) {
        /** Of the known runs; not a number where there are none. */
        public double share() {
            return (double) runs / known;
        }

        /** Where the probability is, whatever the unknown ones would have said. */
        public ConfidenceInterval interval(Confidence confidence) {
            return new ConfidenceInterval(
                    ofSo(runs).exact(confidence).low(),
                    ofSo(runs + unknown).exact(confidence).high());
        }

        private Proportion ofSo(long events) {
            return new Proportion(events, known + unknown, seeds);
        }
    }

    /**
     * Where numbers are: the least, the quartiles and the greatest.
     *
     * @param known of how many runs there is a number
     */
    public record Spread(
            Column column,
            long known,
            double least,
            double lower,
            double median,
            double upper,
            double greatest) {
        static Spread of(Column column, Measurements all) {
            if (all.size() == 0) {
                double none = Double.NaN;
                return new Spread(column, 0, none, none, none, none, none);
            }
            return new Spread(
                    column,
                    all.size(),
                    all.least(),
                    new Quantile(0.25).estimate(all),
                    new Quantile(0.5).estimate(all),
                    new Quantile(0.75).estimate(all),
                    all.greatest());
        }
    }

    /** Whether something that was asked for is not met, or the new variant is worse. */
    public boolean fails() {
        return judgements.stream().anyMatch(each -> each.decision() == Decision.FAILS);
    }

    /** Whether the runs do not decide something that was asked for. */
    public boolean isOpen() {
        return judgements.stream().anyMatch(Judgement::isOpen);
    }
}
