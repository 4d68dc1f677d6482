package arcomat.campaign.against;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.campaign.Column;
import arcomat.campaign.Judge;
import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.campaign.Trials;
import arcomat.campaign.statistics.Decision;
import arcomat.campaign.statistics.Measurements;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.ToDoubleBiFunction;
import java.util.stream.LongStream;

/** Tables whose rows nobody has run, so that what differs is known. */
class TableComparisonTest {
    private static final String TEXT = "world w\nsample random 100\n";

    private static final ToDoubleBiFunction<Trial, Column> QUIET = (trial, column) -> 0;

    /** Something that happens on the seeds that a number divides. */
    private static ToDoubleBiFunction<Trial, Column> every(int number, String name) {
        return (trial, column) -> column.name().equals(name) && trial.seed() % number == 0 ? 1 : 0;
    }

    private static FinishedTable table(String text, ToDoubleBiFunction<Trial, Column> answer) {
        return table(text, answer, Long.MAX_VALUE);
    }

    private static FinishedTable table(
            String text, ToDoubleBiFunction<Trial, Column> answer, long most) {
        Campaign campaign =
                CampaignParser.parse(new SourceFile("a.campaign", text)).campaign().orElseThrow();
        Trials trials = Trials.of(campaign);
        List<Row> rows =
                LongStream.range(0, Math.min(most, trials.count()))
                        .mapToObj(trials::trial)
                        .map(trial -> row(trial, campaign, answer))
                        .toList();
        Judge judge = new Judge(campaign);
        rows.forEach(judge::see);
        return new FinishedTable(
                "t",
                campaign,
                judge.result(column -> measured(rows, campaign.column(column))),
                "",
                rows::stream);
    }

    private static Measurements measured(List<Row> rows, int column) {
        return Measurements.of(() -> rows.stream().mapToDouble(row -> row.answer(column)));
    }

    private static Row row(
            Trial trial, Campaign campaign, ToDoubleBiFunction<Trial, Column> answer) {
        List<Double> answers =
                campaign.columns().stream().map(each -> answer.applyAsDouble(trial, each)).toList();
        return Row.made(trial, answers);
    }

    private static TableDifference.OfEvent event(TableDifference difference, String name) {
        return difference.events().stream()
                .filter(each -> each.now().column().name().equals(name))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void runsOfBothArePaired() {
        FinishedTable before = table(TEXT, every(10, "collision"));
        TableDifference difference = TableComparison.of(before, table(TEXT, every(5, "collision")));
        assertThat(difference.pairs()).isEqualTo(100);
        TableDifference.OfEvent collision = event(difference, "collision");
        assertThat(collision.changes().worse()).isEqualTo(10);
        assertThat(collision.changes().better()).isZero();
        assertThat(collision.decision()).isEqualTo(Decision.FAILS);
        assertThat(difference.isWorse()).isTrue();
        assertThat(event(difference, "deadlock").decision()).isEqualTo(Decision.UNDECIDED);
    }

    /** More goals are better. */
    @Test
    void theGoalIsWanted() {
        FinishedTable before = table(TEXT, every(10, "goal"));
        TableDifference difference = TableComparison.of(before, table(TEXT, every(5, "goal")));
        assertThat(event(difference, "goal").decision()).isEqualTo(Decision.HOLDS);
        assertThat(difference.isWorse()).isFalse();
    }

    /** Six worse pairs are no chance for one event, by 1 of 64; they are for one of four. */
    @Test
    void allEventsShareOneError() {
        FinishedTable before = table(TEXT, QUIET);
        TableDifference six = TableComparison.of(before, table(TEXT, every(16, "collision")));
        assertThat(event(six, "collision").changes().worse()).isEqualTo(6);
        assertThat(event(six, "collision").decision()).isEqualTo(Decision.UNDECIDED);
        TableDifference seven = TableComparison.of(before, table(TEXT, every(14, "collision")));
        assertThat(event(seven, "collision").changes().worse()).isEqualTo(7);
        assertThat(event(seven, "collision").decision()).isEqualTo(Decision.FAILS);
    }

    @Test
    void seedsThatOnlyOneHasAreNoPairs() {
        FinishedTable before = table(TEXT + "seeds from 31\n", every(10, "collision"));
        TableDifference difference = TableComparison.of(before, table(TEXT, QUIET));
        assertThat(difference.pairs()).isEqualTo(70);
        assertThat(difference.isPaired()).isTrue();
        assertThat(event(difference, "collision").changes().better()).isEqualTo(7);
    }

    @Test
    void withoutCommonSeedsIntervalsDecide() {
        FinishedTable before = table(TEXT + "seeds from 1001\n", QUIET);
        TableDifference some = TableComparison.of(before, table(TEXT, every(20, "collision")));
        assertThat(some.pairs()).isZero();
        assertThat(some.isPaired()).isFalse();
        assertThat(event(some, "collision").decision()).isEqualTo(Decision.UNDECIDED);
        TableDifference many = TableComparison.of(before, table(TEXT, every(4, "collision")));
        assertThat(event(many, "collision").decision()).isEqualTo(Decision.FAILS);
        TableDifference back = TableComparison.of(table(TEXT, every(4, "collision")), before);
        assertThat(event(back, "collision").decision()).isEqualTo(Decision.HOLDS);
    }

    /** What a campaign drew otherwise is another run, also on the same seed. */
    @Test
    void valuesHaveToBeTheSame() {
        FinishedTable before = table(TEXT + "vary light from 0 to 3\n", QUIET);
        assertThat(TableComparison.of(before, table(TEXT + "vary light from 0 to 3\n", QUIET)))
                .extracting(TableDifference::pairs)
                .isEqualTo(100L);
        for (String other : List.of("", "vary light from 0 to 2\n")) {
            assertThat(TableComparison.of(before, table(TEXT + other, QUIET)).pairs()).isZero();
        }
    }

    /** A parameter that has one value is what the campaigns differ in. */
    @Test
    void oneWordTellsCampaignsApart() {
        FinishedTable before = table(TEXT + "vary who of old\n", QUIET);
        for (String other : List.of("", "vary who of new\n", "vary who from 3 to 3\n")) {
            assertThat(TableComparison.of(before, table(TEXT + other, QUIET)).pairs())
                    .isEqualTo(100);
        }
        FinishedTable both = table(TEXT + "vary who of old new\n", QUIET);
        assertThat(TableComparison.of(before, both).pairs()).isLessThan(60);
    }

    /** Points of a grid have a seed in common, and it speaks once. */
    @Test
    void aSeedSpeaksOnce() {
        String grid = "world w\nvary light from 0 to 3\nsample grid 30 seeds 2\n";
        TableDifference difference =
                TableComparison.of(table(grid, QUIET), table(grid, every(1, "collision")));
        assertThat(difference.pairs()).isEqualTo(60);
        assertThat(event(difference, "collision").changes().worse()).isEqualTo(60);
        assertThat(event(difference, "collision").decision()).isEqualTo(Decision.UNDECIDED);
    }

    @Test
    void whatMeansSomethingElseIsLeftOut() {
        FinishedTable before = table(TEXT + "event near when one.x > 3\n", every(2, "near"));
        TableDifference other =
                TableComparison.of(before, table(TEXT + "event near when one.x > 4\n", QUIET));
        assertThat(other.others()).containsExactly("near");
        assertThat(other.events()).hasSize(4);
        TableDifference same =
                TableComparison.of(before, table(TEXT + "event near when one.x > 3\n", QUIET));
        assertThat(same.others()).isEmpty();
        assertThat(event(same, "near").decision()).isEqualTo(Decision.HOLDS);
    }

    /** The same requirement, shown something else. */
    @Test
    void whatIsWatchedOtherwiseIsLeftOut() {
        String watch = "watch rude p.Courtesy {\n    a = %s.mind.go\n}\n";
        FinishedTable before = table(TEXT + watch.formatted("one"), QUIET);
        assertThat(TableComparison.of(before, table(TEXT + watch.formatted("two"), QUIET)).others())
                .containsExactly("rude");
        assertThat(TableComparison.of(before, table(TEXT + watch.formatted("one"), QUIET)).others())
                .isEmpty();
    }

    /** How many runs there are depends on what they say: no test knows of that. */
    @Test
    void whoEndedEarlyConcludesNothing() {
        FinishedTable whole = table(TEXT, QUIET);
        FinishedTable early = table(TEXT, every(1, "collision"), 60);
        for (TableDifference each :
                List.of(TableComparison.of(whole, early), TableComparison.of(early, whole))) {
            assertThat(each.pairs()).isEqualTo(60);
            assertThat(event(each, "collision").decision()).isEqualTo(Decision.UNDECIDED);
            assertThat(each.measures()).noneMatch(TableDifference.OfMeasure::differs);
        }
    }

    @Test
    void measuresGoByTheirPairs() {
        ToDoubleBiFunction<Trial, Column> far =
                (trial, column) -> column.name().equals("distance") ? trial.seed() : 0;
        ToDoubleBiFunction<Trial, Column> nearer =
                (trial, column) -> far.applyAsDouble(trial, column) * 0.99;
        TableDifference difference = TableComparison.of(table(TEXT, far), table(TEXT, nearer));
        for (TableDifference.OfMeasure each : difference.measures()) {
            boolean differs = each.now().column().name().equals("distance");
            assertThat(each.differs()).isEqualTo(differs);
            assertThat(each.smaller()).isEqualTo(differs ? 100 : 0);
            assertThat(each.greater()).isZero();
        }
    }

    /** Where nothing differs, at most 5 of 100 comparisons say that something does. */
    @Tag("slow")
    @Test
    void falseAlarmsAreRare() {
        int alarms = 0;
        for (int i = 0; i < 400; i++) {
            SplittableRandom chance = new SplittableRandom(i);
            ToDoubleBiFunction<Trial, Column> answer =
                    (trial, column) -> column.isEvent() && chance.nextInt(3) == 0 ? 1 : 0;
            TableDifference difference =
                    TableComparison.of(table(TEXT, answer), table(TEXT, answer));
            alarms +=
                    difference.events().stream().anyMatch(each -> each.decision() == Decision.FAILS)
                            ? 1
                            : 0;
        }
        assertThat(alarms).isBetween(1, 20);
    }
}
