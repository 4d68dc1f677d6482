package arcomat.lower;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.symbols.Scenario;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.util.List;

/** Every file in the folder is a set of models with the model that they mean. */
class LoweringTest {
    @TestFactory
    List<DynamicTest> modelsMeanWhatIsWrittenBehindThem() {
        return Scenario.in("lower").stream()
                .map(
                        file ->
                                DynamicTest.dynamicTest(
                                        file.getFileName().toString(),
                                        file.toUri(),
                                        () -> {
                                            Scenario scenario = Scenario.read(file);
                                            assertThat(
                                                            ModelText.of(
                                                                    Lowering.lower(
                                                                            scenario.workspace())))
                                                    .isEqualTo(scenario.expected());
                                        }))
                .toList();
    }
}
