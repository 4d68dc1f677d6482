package arcomat.report.campaign;

import arcomat.campaign.WorstSearch;

import java.util.List;
import java.util.Optional;

/**
 * What a search for the worst case has come to, in the form of JSON.
 *
 * @param which smallest or largest
 * @param value absent where it is infinite, or no run has such a number
 * @param runs how many the search made
 * @param unknown of them without such a number
 * @param searches how often it began somewhere else, the first time included
 * @param run absent where no run has such a number
 */
record Worst(
        String which,
        String measure,
        Optional<Double> value,
        int runs,
        int unknown,
        int searches,
        List<Step> course,
        Optional<CampaignAnswer.Run> run) {
    /**
     * A part of its course.
     *
     * @param worst of its runs; absent where none has a finite number
     */
    record Step(int generations, int runs, Optional<Double> worst) {
        static Step of(WorstSearch.Step step) {
            return new Step(step.generations(), step.runs(), step.worst().filter(Double::isFinite));
        }
    }

    static Worst of(WorstSearch search, CampaignReport report) {
        return new Worst(
                search.which(),
                search.search().measure(),
                search.worst().map(WorstSearch.Found::value).filter(Double::isFinite),
                search.runs(),
                search.unknown(),
                search.searches(),
                search.course().stream().map(Step::of).toList(),
                search.worst()
                        .map(
                                found ->
                                        CampaignAnswer.Run.of(
                                                found.row(), report.campaign(), report.replay())));
    }
}
