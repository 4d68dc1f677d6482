package arcomat.report.campaign;

import arcomat.campaign.CampaignResult.Occurrence;
import arcomat.campaign.ChangedPairs;
import arcomat.campaign.Row;
import arcomat.campaign.against.TableDifference;
import arcomat.campaign.statistics.Decision;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A table beside an older one, in the form of JSON.
 *
 * @param name where the older one is kept
 * @param table what tells it from any other
 * @param pairs runs of both
 * @param paired whether they decide; else intervals do
 * @param remarks for people
 */
record TablesAnswer(
        String name,
        String table,
        long runs,
        long pairs,
        boolean paired,
        List<String> remarks,
        List<Event> events,
        List<Measure> measures) {
    /**
     * An event in both.
     *
     * @param decision better, worse or undecided
     * @param better pairs of which only the new run was good
     * @param firstBetter seeds and values of the first of these
     */
    record Event(
            String name,
            Share before,
            Share now,
            String decision,
            long better,
            long worse,
            List<Change> firstBetter,
            List<Change> firstWorse) {
        static Event of(TableDifference.OfEvent event) {
            ChangedPairs changes = event.changes();
            return new Event(
                    event.now().column().name(),
                    Share.of(event.before()),
                    Share.of(event.now()),
                    word(event.decision()),
                    changes.better(),
                    changes.worse(),
                    Change.of(changes.firstBetter()),
                    Change.of(changes.firstWorse()));
        }

        private static String word(Decision decision) {
            return switch (decision) {
                case HOLDS -> "better";
                case FAILS -> "worse";
                case UNDECIDED -> "undecided";
            };
        }
    }

    /** In how many of the known runs it happened. */
    record Share(long runs, long known) {
        static Share of(Occurrence occurrence) {
            return new Share(occurrence.runs(), occurrence.known());
        }
    }

    /** A run of both that went another way; the values are those of the new one. */
    record Change(long seed, Map<String, String> values) {
        static List<Change> of(List<ChangedPairs.Pair> pairs) {
            return pairs.stream().map(ChangedPairs.Pair::after).map(Change::of).toList();
        }

        private static Change of(Row row) {
            return new Change(row.trial().seed(), row.trial().values());
        }
    }

    /**
     * A measure in both, by its medians.
     *
     * @param greater pairs in which the new run has the greater number
     */
    record Measure(
            String name,
            Optional<Double> before,
            Optional<Double> now,
            long greater,
            long smaller,
            boolean differs) {
        static Measure of(TableDifference.OfMeasure measure) {
            return new Measure(
                    measure.now().column().name(),
                    finite(measure.before().median()),
                    finite(measure.now().median()),
                    measure.greater(),
                    measure.smaller(),
                    measure.differs());
        }

        private static Optional<Double> finite(double number) {
            return Optional.of(number).filter(Double::isFinite);
        }
    }

    static TablesAnswer of(TablesReport report) {
        TableDifference difference = report.difference();
        return new TablesAnswer(
                report.before().name(),
                report.before().hash(),
                report.before().runs(),
                difference.pairs(),
                difference.isPaired(),
                report.remarks(),
                difference.events().stream().map(Event::of).toList(),
                difference.measures().stream().map(Measure::of).toList());
    }
}
