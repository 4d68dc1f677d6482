package arcomat.report.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.Demand;

import java.util.List;
import java.util.Optional;

/**
 * A bound that is required.
 *
 * @param side below or above: what is wanted
 */
record Bound(String side, double value) {
    /** Those of a column of the table. */
    static List<Bound> of(String column, Campaign campaign) {
        return campaign.demands().stream()
                .flatMap(
                        demand ->
                                demand
                                        .match(
                                                event -> of(event, column),
                                                share -> of(share, column))
                                        .stream())
                .toList();
    }

    private static Optional<Bound> of(Demand.Probability event, String column) {
        return event.event().equals(column)
                ? Optional.of(new Bound(event.side().word(), event.bound()))
                : Optional.empty();
    }

    private static Optional<Bound> of(Demand.Share share, String column) {
        return share.measure().equals(column)
                ? Optional.of(new Bound(share.side().word(), share.bound()))
                : Optional.empty();
    }
}
