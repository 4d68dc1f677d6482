package arcomat.models;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTestResult.Verdict;
import arcomat.simulate.test.StreamTests;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Formatter;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The case study is flawless: no findings, every test passes, no component goes untested. */
class CoffeeModelsTest {
    private static final Path ROOT = Path.of("models/coffee");

    private static Workspace workspace;
    private static Model model;

    @BeforeAll
    static void read() {
        workspace =
                Workspace.of(
                        ModelFiles.of(ROOT).stream()
                                .map(file -> Parser.parse(file).unit().orElseThrow())
                                .toList(),
                        Set.of(),
                        HouseLanguages.reader());
        model = Lowering.lower(workspace);
    }

    /** The requirements of Fig. 3 and 5 included: what they leave open is no fault of theirs. */
    @ParameterizedTest
    @EnumSource
    void nothingIsFoundFault(Profile profile) {
        assertThat(Checks.run(workspace, profile)).isEmpty();
    }

    @Test
    void everyFileIsFormatted() {
        for (SourceFile file : ModelFiles.under(ROOT)) {
            assertThat(Formatter.format(file).text()).contains(file.text());
        }
    }

    @TestFactory
    Stream<DynamicTest> everyStreamTestPasses() {
        return model.tests().stream()
                .map(
                        test ->
                                DynamicTest.dynamicTest(
                                        test.component().qualifiedName() + " " + test.name(),
                                        () -> {
                                            StreamTestResult result = StreamTests.run(test);
                                            assertThat(result.verdict())
                                                    .as(result.toString())
                                                    .isEqualTo(Verdict.PASSED);
                                        }));
    }

    @Test
    void everyComponentWithBehaviourIsTested() {
        Set<String> tested =
                model.tests().stream()
                        .map(test -> test.component().qualifiedName())
                        .collect(Collectors.toSet());
        // Part of Meeting, and tested with it.
        tested.add("coffee.meeting.Meeting.Cup");

        List<String> untested =
                model.components().stream()
                        .filter(component -> !component.platform())
                        .map(Component::qualifiedName)
                        .filter(name -> !tested.contains(name))
                        .toList();

        assertThat(untested).isEmpty();
    }

    /** Fig. 6 keeps the promise of Fig. 5 only because of this; see the comment in the model. */
    @Test
    void gotCoffeeIsTotal() {
        Component fig6 = model.component("coffee.fig6.AvoidCrash").orElseThrow();
        assertThat(fig6.port("gotCoffee").orElseThrow().total()).isTrue();
        assertThat(fig6.refines()).containsExactly("coffee.fig5.AvoidCrash");
    }
}
