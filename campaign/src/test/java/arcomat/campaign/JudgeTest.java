package arcomat.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Row.Ending;
import arcomat.campaign.statistics.Confidence;
import arcomat.campaign.statistics.Decision;
import arcomat.campaign.statistics.Measurements;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;

/**
 * What nobody knows of a run counts against what is asked for: a table in which it is left out says
 * of all runs what is true of those that please.
 */
class JudgeTest {
    private static final double NONE = Double.NaN;

    private static Campaign campaign(String... lines) {
        String text = "world w\nvary who of A B\nsample random 50\n" + String.join("\n", lines);
        return CampaignParser.parse(new SourceFile("c", text)).campaign().orElseThrow();
    }

    private static Row row(Campaign campaign, long number, String column, double answer) {
        List<Double> answers = new ArrayList<>(Collections.nCopies(campaign.columns().size(), 0.0));
        answers.set(campaign.column(column), answer);
        return Row.made(new Trial(number, number, Map.of()), answers);
    }

    private static Row lost(long number) {
        return Row.withoutAnswers(
                new Trial(number, number, Map.of()), Ending.GIVEN_UP, "after 300 s");
    }

    private static CampaignResult result(Campaign campaign, List<Row> rows) {
        Judge judge = new Judge(campaign);
        rows.forEach(judge::see);
        return judge.result(
                name -> {
                    int column = campaign.column(name);
                    return Measurements.of(
                            () ->
                                    rows.stream()
                                            .filter(row -> row.answers(column))
                                            .mapToDouble(row -> row.answer(column)));
                });
    }

    private static Judgement judgement(Campaign campaign, List<Row> rows) {
        return result(campaign, rows).judgements().get(0);
    }

    /** 50 runs, of which so many have no number, and so many were given up; all others are fine. */
    @ParameterizedTest
    @CsvSource({
        "below 10,  0,  0, HOLDS",
        "below 10, 14,  0, HOLDS",
        "below 10, 32,  0, FAILS",
        "below 10, 50,  0, FAILS",
        "below 10,  0, 32, FAILS",
        "below 10, 16, 16, FAILS",
        "below 10, 25,  0, UNDECIDED",
        "above 1,   0,  0, HOLDS",
        "above 1,  14,  0, HOLDS",
        "above 1,  32,  0, FAILS",
        "above 1,   0, 32, FAILS",
        "above 1,  25,  0, UNDECIDED",
    })
    void aShareOfTheRunsIsOneOfThoseWithoutANumberAsWell(
            String side, int none, int givenUp, Decision decision) {
        Campaign campaign = campaign("require 50 of distance " + side + " at 95");
        List<Row> rows = new ArrayList<>();
        for (int number = 0; number < 50; number++) {
            rows.add(
                    number < givenUp
                            ? lost(number)
                            : row(
                                    campaign,
                                    number,
                                    "distance",
                                    number < givenUp + none ? NONE : 5));
        }
        Judgement judgement = judgement(campaign, rows);
        assertThat(judgement.decision()).isEqualTo(decision);
        String told = "%d without a number count against it".formatted(none + givenUp);
        assertThat(judgement.because().contains(told)).isEqualTo(none + givenUp > 0);
    }

    @ParameterizedTest
    @CsvSource({
        "collision below 0.1, 0,  0, HOLDS",
        "collision below 0.1, 0, 20, FAILS",
        "collision above 0.9, 1,  0, HOLDS",
        "collision above 0.9, 1, 20, FAILS",
    })
    void anEventThatNobodyKnowsOfCountsAgainstWhatIsWanted(
            String wanted, double answer, int none, Decision decision) {
        Campaign campaign = campaign("require " + wanted);
        List<Row> rows = new ArrayList<>();
        for (int number = 0; number < 50; number++) {
            rows.add(row(campaign, number, "collision", number < none ? NONE : answer));
        }
        assertThat(judgement(campaign, rows).decision()).isEqualTo(decision);
    }

    /** 20 of 50 say nothing: whatever they would have said, the interval has it in it. */
    @Test
    void anIntervalHasRoomForWhatNobodyKnows() {
        Campaign campaign = campaign();
        List<Row> rows = new ArrayList<>();
        for (int number = 0; number < 50; number++) {
            rows.add(
                    number < 10
                            ? lost(number)
                            : row(campaign, number, "collision", number < 20 ? NONE : 0));
        }
        CampaignResult.Occurrence collision = result(campaign, rows).occurrences().get(0);
        assertThat(collision.known()).isEqualTo(30);
        assertThat(collision.interval(Confidence.USUAL).low()).isZero();
        assertThat(collision.interval(Confidence.USUAL).high()).isBetween(0.53, 0.56);
    }

    /** Run by run: what the first word did, and the second. */
    @ParameterizedTest
    @CsvSource({
        "bad,  good, 1, 0",
        "good, bad,  0, 1",
        "good, none, 0, 1",
        "good, lost, 0, 1",
        "bad,  none, 0, 0",
        "bad,  lost, 0, 0",
        "none, good, 0, 0",
        "lost, good, 0, 0",
        "lost, lost, 0, 0",
    })
    void whatIsNewGainsNothingByWhatNobodyKnows(
            String before, String after, long better, long worse) {
        Campaign campaign = campaign("compare who by collision");
        Pairing pairing = new Pairing(campaign);
        pairing.see(run(campaign, 0, before));
        pairing.see(run(campaign, 1, after));
        ChangedPairs changes = pairing.changes().orElseThrow();
        assertThat(changes.better()).isEqualTo(better);
        assertThat(changes.worse()).isEqualTo(worse);
    }

    /** Ten points of one seed are one witness, ten seeds are ten. */
    @ParameterizedTest
    @CsvSource({"10, 1, UNDECIDED", "1, 10, FAILS", "3, 4, UNDECIDED", "3, 5, FAILS"})
    void pairsOfOneSeedSpeakOnce(int points, int seeds, Decision decision) {
        Campaign campaign = campaign("compare who by collision at 95");
        Pairing pairing = new Pairing(campaign);
        for (long pair = 0; pair < (long) points * seeds; pair++) {
            for (int word = 0; word < 2; word++) {
                Row row = row(campaign, 2 * pair + word, "collision", word);
                Trial trial = new Trial(2 * pair + word, 1 + pair / points, Map.of());
                pairing.see(Row.made(trial, row.answers()));
            }
        }
        assertThat(pairing.judge().orElseThrow().decision()).isEqualTo(decision);
    }

    private static Row run(Campaign campaign, long number, String how) {
        return switch (how) {
            case "lost" -> lost(number);
            case "none" -> row(campaign, number, "collision", NONE);
            default -> row(campaign, number, "collision", how.equals("bad") ? 1 : 0);
        };
    }
}
