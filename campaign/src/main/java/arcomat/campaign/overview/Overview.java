package arcomat.campaign.overview;

import arcomat.campaign.Campaign;
import arcomat.campaign.ChangedPairs;
import arcomat.campaign.Column;
import arcomat.campaign.Pairing;
import arcomat.campaign.Row;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * The rows of a campaign as a whole.
 *
 * @param firstSeed the smallest one that a run had
 * @param lastSeed the greatest one
 * @param histograms of the measures, in the order of the columns
 * @param maps of any two of the first parameters that vary; of the only one, with one row
 * @param changes where two words are compared: what the second one changed
 */
public record Overview(
        long firstSeed,
        long lastSeed,
        List<Histogram> histograms,
        List<HeatMap> maps,
        Optional<ChangedPairs> changes) {
    /** So many parameters can be chosen for a map: ten pairs are 4,000 cells. */
    private static final int PARAMETERS = 5;

    public Overview {
        histograms = List.copyOf(histograms);
        maps = List.copyOf(maps);
    }

    /**
     * Reads the rows twice.
     *
     * @param rows all of them, in the order of their numbers
     */
    public static Overview of(Campaign campaign, Supplier<Stream<Row>> rows) {
        FirstLook first = new FirstLook(campaign);
        try (Stream<Row> all = rows.get()) {
            all.forEach(first::see);
        }
        SecondLook second = new SecondLook(campaign, first);
        try (Stream<Row> all = rows.get()) {
            all.forEach(second::see);
        }
        return second.overview();
    }

    private static final class FirstLook {
        private final List<Histogram.Extent> extents = new ArrayList<>();
        private long runs;
        private long firstSeed = Long.MAX_VALUE;
        private long lastSeed = Long.MIN_VALUE;

        FirstLook(Campaign campaign) {
            campaign.columns().forEach(each -> extents.add(new Histogram.Extent()));
        }

        void see(Row row) {
            runs++;
            firstSeed = Math.min(firstSeed, row.trial().seed());
            lastSeed = Math.max(lastSeed, row.trial().seed());
            for (int i = 0; i < row.answers().size(); i++) {
                extents.get(i).see(row.answer(i));
            }
        }
    }

    private static final class SecondLook {
        private final FirstLook first;
        private final List<Column> columns;
        private final List<Histogram.Count> histograms = new ArrayList<>();
        private final List<HeatMap.Count> maps;
        private final Pairing pairing;

        SecondLook(Campaign campaign, FirstLook first) {
            this.first = first;
            this.columns = campaign.columns();
            for (int i = 0; i < columns.size(); i++) {
                histograms.add(new Histogram.Count(columns.get(i), first.extents.get(i)));
            }
            this.maps = maps(campaign, first.runs);
            this.pairing = new Pairing(campaign);
        }

        private static List<HeatMap.Count> maps(Campaign campaign, long runs) {
            List<Axis> axes =
                    campaign.variations().stream()
                            .map(each -> Axis.of(each, campaign.plan(), runs))
                            .filter(each -> each.labels().size() > 1)
                            .limit(PARAMETERS)
                            .toList();
            List<HeatMap.Count> maps = new ArrayList<>();
            for (int i = 0; i < axes.size(); i++) {
                for (int j = i + 1; j < axes.size(); j++) {
                    maps.add(new HeatMap.Count(campaign.columns(), axes.get(i), axes.get(j)));
                }
            }
            if (axes.size() == 1) {
                maps.add(new HeatMap.Count(campaign.columns(), axes.get(0), Axis.none()));
            }
            return maps;
        }

        void see(Row row) {
            pairing.see(row);
            if (!row.wasMade()) {
                return;
            }
            for (int i = 0; i < columns.size(); i++) {
                histograms.get(i).see(row.answer(i));
            }
            maps.forEach(each -> each.see(row));
        }

        Overview overview() {
            return new Overview(
                    first.firstSeed,
                    first.lastSeed,
                    histograms.stream()
                            .map(Histogram.Count::histogram)
                            .filter(each -> !each.column().isEvent())
                            .toList(),
                    maps.stream().map(HeatMap.Count::map).toList(),
                    pairing.changes());
        }
    }
}
