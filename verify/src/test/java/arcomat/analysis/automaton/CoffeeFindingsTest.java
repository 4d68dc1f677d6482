package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Model;
import arcomat.models.ModelFiles;
import arcomat.models.ReadModels;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.nio.file.Path;
import java.util.List;

/** What is known of the three versions of AvoidCrash. */
class CoffeeFindingsTest {
    private static Model model;

    @BeforeAll
    static void read() {
        model = ReadModels.model(ModelFiles.of(Path.of("models/coffee")));
    }

    @ParameterizedTest
    @CsvSource({"fig3, 1", "fig5, 1", "fig6, 0"})
    void overlaps(String figure, int count) {
        List<Finding> overlaps = findings(figure, Overlap.CODE);
        assertThat(overlaps).hasSize(count);
        for (Finding overlap : overlaps) {
            assertThat(overlap.diagnostic().message())
                    .startsWith("in driving on {frontUS = tooClose} ")
                    .contains("what is sent differs", "{cmd = stop}");
            assertThat(overlap.trace()).hasSize(1);
        }
    }

    @ParameterizedTest
    @CsvSource({"fig3", "fig5", "fig6"})
    void everyStateIsReachedAndEveryTransitionTaken(String figure) {
        assertThat(findings(figure, UnreachableState.CODE)).isEmpty();
        assertThat(findings(figure, DeadTransition.CODE)).isEmpty();
        assertThat(examination(figure).obstacle()).isEmpty();
    }

    /**
     * Fig. 3 and Fig. 5 are chaos wherever the paper draws no arrow; Fig. 6 says what it ignores.
     */
    @ParameterizedTest
    @CsvSource({
        "fig3, driving sidestep waiting",
        "fig5, driving backing waiting remote returning",
        "fig6, ''"
    })
    void unhandledInputs(String figure, String states) {
        assertThat(findings(figure, Completeness.CODE))
                .extracting(finding -> finding.diagnostic().span().text())
                .containsExactly(states.isEmpty() ? new String[0] : states.split(" "));
        assertThat(findings(figure, VacuousOnSilence.CODE)).hasSize(states.isEmpty() ? 0 : 1);
    }

    /** Both leave states that nothing leads out of; Fig. 6 closes the circle. */
    @ParameterizedTest
    @CsvSource({"fig3, sidestep", "fig5, returning"})
    void traps(String figure, String state) {
        assertThat(findings(figure, Trap.CODE))
                .singleElement()
                .satisfies(
                        trap ->
                                assertThat(trap.diagnostic().message())
                                        .startsWith("from " + state + " on "));
    }

    @Test
    void theVersionThatRunsIsFlawless() {
        assertThat(examination("fig6").findings()).isEmpty();
    }

    @Test
    void everyWitnessIsReplayed() {
        Models.examine(model).forEach(Replay::all);
    }

    private static List<Finding> findings(String figure, String code) {
        return examination(figure).findings().stream()
                .filter(finding -> finding.code().equals(code))
                .toList();
    }

    private static Examination examination(String figure) {
        return Models.examine(model.component("coffee." + figure + ".AvoidCrash").orElseThrow())
                .get(0);
    }
}
