package arcomat.lower;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Model;
import arcomat.symbols.Scenario;
import arcomat.symbols.Workspace;

import org.junit.jupiter.api.Test;

/** Lowering is total: every shipped model and each of its tests has a meaning. */
class ShippedModelsTest {
    @Test
    void everyModelOfTheCoffeeServiceIsLowered() {
        Workspace workspace = Scenario.models("models/coffee");
        Model model = Lowering.lower(workspace);
        assertThat(model.components()).hasSizeGreaterThanOrEqualTo(workspace.components().size());
        assertThat(model.tests())
                .hasSize(
                        workspace.testSuites().stream()
                                .mapToInt(suite -> suite.tests().size())
                                .sum())
                .allSatisfy(test -> assertThat(test.expected()).isNotEmpty());
        assertThat(ModelText.of(model)).isEqualTo(ModelText.of(Lowering.lower(workspace)));
    }
}
