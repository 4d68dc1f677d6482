package arcomat.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.WorstSearch.Step;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.List;
import java.util.Optional;

/** The course of a search is kept short, and loses neither runs nor the worst number. */
class WorstSearchTest {
    private static final int GENERATIONS = 100_000;

    private static List<Step> course(Demand.Side side) {
        List<Step> course = List.of();
        for (int i = 0; i < GENERATIONS; i++) {
            double number = i == 77_777 ? 0.5 : i == 44_444 ? 1e9 : 5 + i % 13;
            boolean lost = i % 10 == 0;
            Step next = new Step(1, 8, lost ? 8 : 0, lost ? Optional.empty() : Optional.of(number));
            course = WorstSearch.with(course, next, side);
        }
        return course;
    }

    @ParameterizedTest
    @EnumSource
    void veryManyGenerationsAreDrawnTogether(Demand.Side side) {
        List<Step> course = course(side);
        Campaign.Search search =
                CampaignParser.parse(
                                new SourceFile(
                                        "c",
                                        "world w\nvary a from 0 to 1\nsample random 1\n"
                                                + "worst smallest distance runs 10\n"))
                        .campaign()
                        .flatMap(Campaign::search)
                        .orElseThrow();
        WorstSearch all = new WorstSearch(search, course, Optional.empty(), 1);
        assertThat(course).hasSizeBetween(100, 200);
        assertThat(course.stream().mapToInt(Step::generations).sum()).isEqualTo(GENERATIONS);
        assertThat(all.runs()).isEqualTo(8 * GENERATIONS);
        assertThat(all.unknown()).isEqualTo(8 * GENERATIONS / 10);
        assertThat(course.stream().flatMap(step -> step.worst().stream()))
                .contains(side == Demand.Side.BELOW ? 0.5 : 1e9);
    }

    @Test
    void aStepWithoutANumberTakesNothingAway() {
        List<Step> course = course(Demand.Side.BELOW);
        assertThat(course.subList(0, course.size() - 1))
                .allMatch(step -> step.worst().isPresent())
                .extracting(Step::generations)
                .containsOnly(course.get(0).generations());
    }
}
