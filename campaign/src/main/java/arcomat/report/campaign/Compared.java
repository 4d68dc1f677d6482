package arcomat.report.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.ChangedPairs;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Two words of a parameter on the same seeds; of the seeds that changed, the first ones. */
record Compared(
        String parameter,
        String before,
        String after,
        String event,
        long pairs,
        long better,
        long worse,
        List<Change> firstBetter,
        List<Change> firstWorse) {
    /**
     * A seed on which the two words differ.
     *
     * @param values of the other parameters
     * @param before the command that makes the run with the first word
     * @param after and that with the second
     */
    record Change(long seed, Map<String, String> values, String before, String after) {
        static Change of(ChangedPairs.Pair pair, String parameter, RunAgain replay) {
            Map<String, String> others = new LinkedHashMap<>(pair.after().trial().values());
            others.remove(parameter);
            return new Change(
                    pair.after().trial().seed(),
                    others,
                    replay.command(pair.before(), "build/before"),
                    replay.command(pair.after(), "build/after"));
        }
    }

    /** Empty where nothing is compared. */
    static Optional<Compared> of(CampaignReport report) {
        return report.campaign()
                .comparison()
                .flatMap(
                        asked ->
                                report.overview()
                                        .changes()
                                        .map(changes -> of(asked, changes, report)));
    }

    private static Compared of(
            Campaign.Comparison asked, ChangedPairs changes, CampaignReport report) {
        List<String> words =
                report.campaign().variations().stream()
                        .filter(each -> each.parameter().equals(asked.parameter()))
                        .flatMap(each -> each.steps(2).stream())
                        .toList();
        return new Compared(
                asked.parameter(),
                words.get(0),
                words.get(1),
                asked.event(),
                changes.pairs(),
                changes.better(),
                changes.worse(),
                changed(changes.firstBetter(), asked, report),
                changed(changes.firstWorse(), asked, report));
    }

    private static List<Change> changed(
            List<ChangedPairs.Pair> pairs, Campaign.Comparison asked, CampaignReport report) {
        return pairs.stream()
                .map(pair -> Change.of(pair, asked.parameter(), report.replay()))
                .toList();
    }
}
