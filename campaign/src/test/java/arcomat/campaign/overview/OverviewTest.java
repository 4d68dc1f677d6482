package arcomat.campaign.overview;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.campaign.Column;
import arcomat.campaign.Row;
import arcomat.campaign.Row.Ending;
import arcomat.campaign.Trial;
import arcomat.campaign.Trials;
import arcomat.campaign.overview.HeatMap.Cell;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.function.BiFunction;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/** Counts of rows whose sums are known. */
class OverviewTest {
    private static Campaign campaign(String text) {
        return CampaignParser.parse(new SourceFile("c", "world w\n" + text))
                .campaign()
                .orElseThrow();
    }

    /** All runs, with an answer for each column. */
    private static Overview overview(Campaign campaign, BiFunction<Trial, Column, Double> answer) {
        Trials trials = Trials.of(campaign);
        return Overview.of(
                campaign,
                () ->
                        LongStream.range(0, trials.count())
                                .mapToObj(trials::trial)
                                .map(trial -> row(campaign, trial, answer)));
    }

    private static Row row(
            Campaign campaign, Trial trial, BiFunction<Trial, Column, Double> answer) {
        Stream<Double> answers =
                campaign.columns().stream().map(column -> answer.apply(trial, column));
        return Row.made(trial, answers.toList());
    }

    private static HeatMap.Layer layer(HeatMap map, String name) {
        return map.layers().stream()
                .filter(each -> each.column().name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void everyRunIsInOneBin() {
        Campaign campaign = campaign("seeds from 1\nsample random 1000\n");
        Overview overview = overview(campaign, (trial, column) -> trial.seed() / 10.0);
        assertThat(overview.firstSeed()).isEqualTo(1);
        assertThat(overview.lastSeed()).isEqualTo(1000);
        Histogram time = overview.histograms().get(0);
        assertThat(time.scale()).isEqualTo(new Scale(0, 5, 21, false)); // to 100, which is one more
        assertThat(time.counts().get(0)).isEqualTo(49); // 0.1 to 4.9
        assertThat(time.counts().get(20)).isEqualTo(1);
        assertThat(time.counts().stream().mapToLong(each -> each).sum()).isEqualTo(1000);
    }

    @Test
    void whatIsNoNumberIsCountedApart() {
        Overview overview =
                overview(
                        campaign("sample random 30\n"),
                        (trial, column) ->
                                switch ((int) (trial.number() % 3)) {
                                    case 0 -> Double.NaN;
                                    case 1 -> Double.POSITIVE_INFINITY;
                                    default -> 3.0;
                                });
        Histogram time = overview.histograms().get(0);
        assertThat(time)
                .isEqualTo(
                        new Histogram(
                                time.column(), new Scale(3, 0, 1, true), List.of(10L), 10, 10));
    }

    @Test
    void nothingToCountIsNothing() {
        Overview overview = overview(campaign("sample random 3\n"), (trial, column) -> Double.NaN);
        assertThat(overview.histograms())
                .allSatisfy(each -> assertThat(each.counts()).isEmpty())
                .allSatisfy(each -> assertThat(each.unknown()).isEqualTo(3));
    }

    @Test
    void aGridHasAPlaceForEachOfItsPoints() {
        Campaign campaign =
                campaign("vary a from 0 to 1\nvary b of x y z\nsample grid 3 seeds 5\n");
        Overview overview =
                overview(
                        campaign,
                        (trial, column) -> {
                            double a = Double.parseDouble(trial.values().get("a"));
                            return column.isEvent() ? (a == 1 ? 1.0 : 0.0) : a + trial.seed();
                        });
        HeatMap map = overview.maps().get(0);
        assertThat(map.across().labels()).containsExactly("0", "0.5", "1");
        assertThat(map.up().labels()).containsExactly("x", "y", "z");
        assertThat(map.runs()).hasSize(9).containsOnly(5L);
        assertThat(layer(map, "collision").cells()).extracting(Cell::mean).contains(0.0, 1.0);
        assertThat(layer(map, "collision").cells().get(2)).isEqualTo(new Cell(5, 1, 1, 1));
        assertThat(layer(map, "time").cells().get(4)).isEqualTo(new Cell(5, 1.5, 3.5, 5.5));
    }

    @Tag("slow")
    @Test
    void manyRunsMakeAFineMapAndFewACoarseOne() {
        String vary = "vary a from 0 to 1\nvary b from 1 to 7 whole\n";
        assertThat(places(vary + "sample random 50\n")).containsExactly(4, 7);
        assertThat(places(vary + "sample random 1000\n")).containsExactly(5, 7);
        assertThat(places(vary + "sample latin 100000\n")).containsExactly(20, 7);
        assertThat(places(vary + "sample grid 200\n")).containsExactly(5, 7);
    }

    private static List<Integer> places(String text) {
        HeatMap map = overview(campaign(text), (trial, column) -> 0.0).maps().get(0);
        return List.of(map.across().labels().size(), map.up().labels().size());
    }

    @Test
    void oneParameterHasAMapOfOneRow() {
        HeatMap map =
                overview(campaign("vary a of x y\nsample random 100\n"), (trial, column) -> 0.0)
                        .maps()
                        .get(0);
        assertThat(map.up().parameter()).isEmpty();
        assertThat(map.runs().stream().mapToLong(each -> each).sum()).isEqualTo(100);
    }

    @Test
    void anyTwoOfFiveParametersHaveAMap() {
        StringBuilder text = new StringBuilder("sample random 20\nvary same of x\n");
        for (String name : List.of("a", "b", "c", "d", "e", "f")) {
            text.append("vary ").append(name).append(" from 0 to 1\n");
        }
        Overview overview = overview(campaign(text.toString()), (trial, column) -> 0.0);
        assertThat(overview.maps()).hasSize(10);
        assertThat(overview.maps()).noneMatch(map -> map.across().parameter().equals("same"));
    }

    @Test
    void wordsBeyondTheLastPlaceAreTheOthers() {
        String words =
                String.join(" ", LongStream.range(0, 25).mapToObj(number -> "w" + number).toList());
        HeatMap map =
                overview(
                                campaign("vary a of " + words + "\nsample grid 1 seeds 2\n"),
                                (trial, column) -> 0.0)
                        .maps()
                        .get(0);
        assertThat(map.across().labels()).hasSize(20).endsWith("w18", "others");
        assertThat(map.runs()).endsWith(2L, 12L);
    }

    @Test
    void theFirstSeedsThatChangedAreKept() {
        Campaign campaign =
                campaign("vary who of old new\nsample random 100\ncompare who by collision\n");
        Overview overview =
                overview(
                        campaign,
                        (trial, column) -> {
                            boolean old = trial.values().get("who").equals("old");
                            return old && trial.seed() > 10 || !old && trial.seed() <= 3
                                    ? 1.0
                                    : 0.0;
                        });
        var changes = overview.changes().orElseThrow();
        assertThat(changes.pairs()).isEqualTo(100);
        assertThat(changes.better()).isEqualTo(90);
        assertThat(changes.worse()).isEqualTo(3);
        assertThat(changes.firstWorse())
                .extracting(pair -> pair.after().trial().seed())
                .containsExactly(1L, 2L, 3L);
        assertThat(changes.firstBetter()).hasSize(20);
        assertThat(changes.firstBetter().get(0).before().trial().seed()).isEqualTo(11);
    }

    @Test
    void aRunThatWasNotMadeCountsNowhere() {
        Campaign campaign = campaign("vary a of x y\nsample random 10\n");
        Trials trials = Trials.of(campaign);
        Overview overview =
                Overview.of(
                        campaign,
                        () ->
                                LongStream.range(0, 10)
                                        .mapToObj(trials::trial)
                                        .map(
                                                trial ->
                                                        Row.withoutAnswers(
                                                                trial, Ending.IMPOSSIBLE, "no")));
        assertThat(overview.maps().get(0).runs()).containsOnly(0L);
        assertThat(overview.histograms()).allMatch(each -> each.counts().isEmpty());
    }
}
