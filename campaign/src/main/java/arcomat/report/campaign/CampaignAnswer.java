package arcomat.report.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignResult;
import arcomat.campaign.CampaignResult.Occurrence;
import arcomat.campaign.CampaignResult.Spread;
import arcomat.campaign.Judgement;
import arcomat.campaign.Row;
import arcomat.campaign.Variation;
import arcomat.campaign.overview.Histogram;
import arcomat.campaign.overview.Overview;
import arcomat.campaign.statistics.Confidence;
import arcomat.campaign.statistics.ConfidenceInterval;
import arcomat.report.text.Printable;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What JSON and the page say, in the form of JSON: components are its fields.
 *
 * @param runs rows of the table: those that were made, those whose values make no world, and those
 *     that were given up
 */
record CampaignAnswer(
        String campaign,
        String world,
        String verdict,
        String headline,
        long runs,
        long planned,
        long made,
        long impossible,
        long givenUp,
        long firstSeed,
        long lastSeed,
        String table,
        List<Parameter> parameters,
        List<Verdict> verdicts,
        List<Event> events,
        List<Measure> measures,
        List<Run> notable,
        CoverageAnswer coverage,
        Optional<Compared> compared,
        Optional<Worst> worst,
        Optional<Rare> rare,
        List<TablesAnswer> against) {
    /** A parameter that varies, in the campaign's words. */
    record Parameter(String name, String values) {
        static Parameter of(Variation variation) {
            String values =
                    variation
                            .domain()
                            .match(
                                    range ->
                                            variation.steps(2).get(0)
                                                    + " to "
                                                    + range.at(1)
                                                    + (range.whole() ? ", whole" : ""),
                                    choice -> String.join(", ", choice.words()));
            return new Parameter(variation.parameter(), values);
        }
    }

    /**
     * What is said of a requirement, or of the comparison.
     *
     * @param required false for a comparison
     * @param decision holds, fails or undecided; of a comparison: better, worse or undecided
     */
    record Verdict(String subject, boolean required, String decision, String because) {
        static Verdict of(Judgement judgement) {
            String decision = Printable.word(judgement.decision());
            if (!judgement.isDemand()) {
                decision = decision.replace("holds", "better").replace("fails", "worse");
            }
            return new Verdict(
                    judgement.subject(), judgement.isDemand(), decision, judgement.because());
        }
    }

    /**
     * How often something happened.
     *
     * @param runs in which it did
     * @param known runs that say whether it did
     * @param low of the interval, whatever the others would have said
     */
    record Event(
            String name,
            String meaning,
            long runs,
            long known,
            Optional<Double> share,
            double low,
            double high,
            List<Bound> bounds) {
        static Event of(Occurrence occurrence, Campaign campaign) {
            String name = occurrence.column().name();
            ConfidenceInterval interval = occurrence.interval(Confidence.USUAL);
            return new Event(
                    name,
                    occurrence.column().meaning(),
                    occurrence.runs(),
                    occurrence.known(),
                    finite(occurrence.share()),
                    interval.low(),
                    interval.high(),
                    Bound.of(name, campaign));
        }
    }

    /**
     * Where the numbers of a measure are.
     *
     * @param known runs that have one, an infinite one included
     * @param never runs in which it is infinite: it did not come to that
     * @param from where the first bin begins
     * @param width of each bin; 0 where all numbers are one
     * @param whole whether all numbers are whole
     * @param bins how many runs are in each
     */
    record Measure(
            String name,
            String meaning,
            long known,
            Optional<Double> least,
            Optional<Double> lower,
            Optional<Double> median,
            Optional<Double> upper,
            Optional<Double> greatest,
            long never,
            double from,
            double width,
            boolean whole,
            List<Long> bins,
            List<Bound> bounds) {
        static Measure of(Spread spread, Overview overview, Campaign campaign) {
            String name = spread.column().name();
            Histogram histogram =
                    overview.histograms().stream()
                            .filter(each -> each.column().name().equals(name))
                            .findFirst()
                            .orElseThrow();
            return new Measure(
                    name,
                    spread.column().meaning(),
                    spread.known(),
                    finite(spread.least()),
                    finite(spread.lower()),
                    finite(spread.median()),
                    finite(spread.upper()),
                    finite(spread.greatest()),
                    histogram.never(),
                    histogram.scale().low(),
                    histogram.scale().width(),
                    histogram.scale().whole(),
                    histogram.counts(),
                    Bound.of(name, campaign));
        }
    }

    /**
     * A run to look at.
     *
     * @param events that happened in it
     * @param measures its numbers, by name
     * @param command makes it again
     */
    record Run(
            long run,
            long seed,
            Map<String, String> values,
            List<String> events,
            Map<String, Double> measures,
            String command) {
        static Run of(Row row, Campaign campaign, RunAgain replay) {
            RowAnswers answers = RowAnswers.of(row, campaign);
            return new Run(
                    row.trial().number(),
                    row.trial().seed(),
                    row.trial().values(),
                    answers.events(),
                    answers.measures(),
                    replay.command(row));
        }
    }

    static CampaignAnswer of(CampaignReport report) {
        Campaign campaign = report.campaign();
        CampaignResult result = report.result();
        Overview overview = report.overview();
        return new CampaignAnswer(
                report.file(),
                report.replay().world(),
                verdict(report),
                report.headline(),
                report.runs(),
                report.planned(),
                result.made(),
                result.impossible(),
                result.givenUp(),
                overview.firstSeed(),
                overview.lastSeed(),
                report.table(),
                campaign.variations().stream().map(Parameter::of).toList(),
                result.judgements().stream().map(Verdict::of).toList(),
                result.occurrences().stream().map(each -> Event.of(each, campaign)).toList(),
                result.spreads().stream()
                        .map(each -> Measure.of(each, overview, campaign))
                        .toList(),
                result.notable().stream()
                        .map(each -> Run.of(each, campaign, report.replay()))
                        .toList(),
                CoverageAnswer.of(report.coverage()),
                Compared.of(report),
                report.worst().map(each -> Worst.of(each, report)),
                report.rare().map(each -> Rare.of(each, report)),
                report.against().stream().map(TablesAnswer::of).toList());
    }

    private static String verdict(CampaignReport report) {
        if (report.fails()) {
            return "fails";
        }
        return report.result().isOpen() ? "undecided" : "holds";
    }

    private static Optional<Double> finite(double number) {
        return Optional.of(number).filter(Double::isFinite);
    }
}
