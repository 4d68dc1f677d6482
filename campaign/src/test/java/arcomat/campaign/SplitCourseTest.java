package arcomat.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.statistics.Confidence;
import arcomat.source.SourceFile;
import arcomat.world.Seeds;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** A walk whose probability is known: a step nearer or farther at each moment, by a coin. */
class SplitCourseTest {
    private static final int STEPS = 100;
    private static final int START = 31;
    private static final List<Integer> LEVELS = List.of(19, 10, 1);

    private static Campaign campaign(int runs, long seed) {
        String text =
                """
                world a.world
                vary a from 0 to 1
                sample random 7
                seeds from %d
                split on distance levels 19 10 1 runs %d
                """
                        .formatted(seed, runs);
        return CampaignParser.parse(new SourceFile("a.campaign", text)).campaign().orElseThrow();
    }

    /** As a world would make it: what is drawn depends on the moment and on who draws then. */
    private static Row run(Campaign campaign, Trial trial) {
        int distance = START;
        int least = START;
        Map<Integer, Double> reached = new java.util.TreeMap<>();
        for (int tick = 0; tick < STEPS; tick++) {
            for (int level : LEVELS) {
                if (distance <= level) {
                    reached.putIfAbsent(level, tick / 100.0);
                }
            }
            least = Math.min(least, distance);
            distance += coin(seedAt(trial.seeds(), tick), tick) ? 1 : -1;
        }
        List<Double> answers = new ArrayList<>(Collections.nCopies(Column.builtIn().size(), 0.0));
        answers.set(campaign.column("distance"), (double) least);
        LEVELS.forEach(level -> answers.add(reached.getOrDefault(level, Double.POSITIVE_INFINITY)));
        return Row.made(trial, answers);
    }

    private static long seedAt(Seeds seeds, long tick) {
        return seeds.changes().stream()
                .filter(change -> change.tick() <= tick)
                .reduce((before, last) -> last)
                .map(Seeds.Change::seed)
                .orElse(seeds.first());
    }

    private static boolean coin(long seed, long tick) {
        long bits = (seed * 0x9E3779B97F4A7C15L) ^ (tick * 0xD1B54A32D192ED03L);
        bits = (bits ^ bits >>> 30) * 0xBF58476D1CE4E5B9L;
        bits = (bits ^ bits >>> 27) * 0x94D049BB133111EBL;
        return (bits ^ bits >>> 31) < 0;
    }

    /** That it is at 1 at one of the moments: all walks, with their probabilities. */
    private static double exact() {
        double[] at = new double[START + STEPS + 2];
        at[START] = 1;
        for (int tick = 1; tick < STEPS; tick++) {
            double[] next = new double[at.length];
            next[1] = at[1];
            for (int place = 2; place < at.length - 1; place++) {
                next[place - 1] += at[place] / 2;
                next[place + 1] += at[place] / 2;
            }
            at = next;
        }
        return at[1];
    }

    private static RareEvent split(Campaign campaign) {
        SplitCourse course = SplitCourse.start(campaign, campaign.split().orElseThrow());
        while (!course.isOver()) {
            List<Row> rows = course.trials().stream().map(trial -> run(campaign, trial)).toList();
            course = course.next(rows);
        }
        return course.result();
    }

    @Tag("slow")
    @Test
    void isRightOnAverage() {
        double[] estimates =
                IntStream.range(0, 400)
                        .mapToDouble(i -> split(campaign(100, 10_000L * i)).estimate())
                        .toArray();
        double mean = DoubleStream.of(estimates).average().orElseThrow();
        double variance =
                DoubleStream.of(estimates).map(each -> (each - mean) * (each - mean)).sum()
                        / (estimates.length - 1);
        assertThat(exact()).isBetween(0.001, 0.01);
        assertThat(Math.abs(mean - exact()))
                .as("mean %s of %s", mean, exact())
                .isLessThan(3 * Math.sqrt(variance / estimates.length));
    }

    @Tag("slow")
    @Test
    void intervalsContainTheProbabilityAboutAsOftenAsTheySay() {
        long right =
                IntStream.range(0, 200)
                        .mapToObj(i -> split(campaign(500, 100_000L * i)))
                        .filter(each -> each.interval(new Confidence(0.95)).contains(exact()))
                        .count();
        assertThat(right).isBetween(180L, 198L);
    }

    @Test
    void aRunOfALaterLevelDoesWhatItsParentDidAndHasItsValues() {
        Campaign campaign = campaign(200, 1);
        SplitCourse start = SplitCourse.start(campaign, campaign.split().orElseThrow());
        List<Row> first = start.trials().stream().map(trial -> run(campaign, trial)).toList();
        int column = campaign.column("within_19");
        for (Trial trial : start.next(first).trials()) {
            Row parent =
                    first.stream()
                            .filter(row -> row.trial().seed() == trial.seed())
                            .findFirst()
                            .orElseThrow();
            assertThat(trial.values()).isEqualTo(parent.trial().values());
            assertThat(run(campaign, trial).answer(column)).isEqualTo(parent.answer(column));
            assertThat(trial.seeds().changes().get(0).tick())
                    .isEqualTo(Math.round(parent.answer(column) * 100));
        }
    }

    @Test
    void whereNobodyComesNothingIsClaimedButTheFirstLevel() {
        Campaign campaign = campaign(10, 3);
        SplitCourse course = SplitCourse.start(campaign, campaign.split().orElseThrow());
        List<Row> rows =
                course.trials().stream()
                        .map(
                                trial ->
                                        Row.made(
                                                trial,
                                                Collections.nCopies(
                                                        campaign.columns().size(),
                                                        Double.POSITIVE_INFINITY)))
                        .toList();
        course = course.next(rows);
        assertThat(course.isOver()).isTrue();
        assertThat(course.result().estimate()).isZero();
        assertThat(course.result().interval(new Confidence(0.95)).high()).isBetween(0.2, 0.4);
    }

    @Test
    void runsThatWereGivenUpLeaveItOpen() {
        Campaign campaign = campaign(10, 3);
        SplitCourse course = SplitCourse.start(campaign, campaign.split().orElseThrow());
        List<Row> rows =
                course.trials().stream()
                        .map(
                                trial ->
                                        trial.number() % 2 == 0
                                                ? run(campaign, trial)
                                                : Row.withoutAnswers(
                                                        trial, Row.Ending.GIVEN_UP, "slow"))
                        .toList();
        assertThat(course.next(rows).result().isKnown()).isFalse();
    }
}
