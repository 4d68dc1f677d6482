package arcomat.report.campaign;

import arcomat.campaign.RareEvent;
import arcomat.campaign.statistics.Confidence;
import arcomat.campaign.statistics.ConfidenceInterval;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What a splitting says, in the form of JSON.
 *
 * @param measure the distance that becomes small
 * @param asked the last level, in mm
 * @param probability that it comes to the last level; absent where runs were given up
 * @param low the interval's, 95 %
 * @param families of the runs that came to the last level
 * @param runs of all levels
 * @param nearest absent where no run has such a distance
 */
record Rare(
        String measure,
        int asked,
        Optional<Double> probability,
        Optional<Double> low,
        Optional<Double> high,
        List<Step> levels,
        long families,
        long runs,
        long givenUp,
        Optional<CampaignAnswer.Run> nearest) {
    /**
     * A level.
     *
     * @param level in mm
     * @param runs that started at the level before
     * @param reached how many of them came to this one
     */
    record Step(int level, long runs, long reached) {}

    static Rare of(RareEvent event, CampaignReport report) {
        Optional<RareEvent> known = Optional.of(event).filter(RareEvent::isKnown);
        Optional<ConfidenceInterval> interval = known.map(each -> each.interval(Confidence.USUAL));
        return new Rare(
                event.split().measure(),
                event.event(),
                known.map(RareEvent::estimate),
                interval.map(ConfidenceInterval::low),
                interval.map(ConfidenceInterval::high),
                steps(event),
                event.families().count(),
                event.runs(),
                event.givenUp(),
                event.nearest()
                        .map(each -> each.row())
                        .map(
                                row ->
                                        CampaignAnswer.Run.of(
                                                row, report.campaign(), report.replay())));
    }

    private static List<Step> steps(RareEvent event) {
        List<Step> steps = new ArrayList<>();
        for (int i = 0; i < event.levels().size(); i++) {
            steps.add(
                    new Step(
                            event.split().levels().get(i),
                            event.levels().get(i).started(),
                            event.levels().get(i).reached()));
        }
        return steps;
    }
}
