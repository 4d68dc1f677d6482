package arcomat.symbols;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.util.List;

/** Every file in the folder is a set of models with what their names resolve to. */
class SymbolsTest {
    @TestFactory
    List<DynamicTest> namesMeanWhatIsWrittenBehindTheModels() {
        return Scenario.in("symbols").stream()
                .map(
                        file ->
                                DynamicTest.dynamicTest(
                                        file.getFileName().toString(),
                                        file.toUri(),
                                        () -> {
                                            Scenario scenario = Scenario.read(file);
                                            assertThat(SymbolText.of(scenario.workspace()))
                                                    .isEqualTo(scenario.expected());
                                        }))
                .toList();
    }
}
