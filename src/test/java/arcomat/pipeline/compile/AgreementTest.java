package arcomat.pipeline.compile;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.generate.SampleComponents;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.model.Value;
import arcomat.source.Diagnostic;
import arcomat.symbols.Scenario;
import arcomat.symbols.Workspace;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;

/** Interpreter and compiled code give the same traces: outputs, states, transitions, errors. */
class AgreementTest {
    private static final int LETTERS = 50;

    @Test
    void onAnAutomatonWithAChoice() {
        Agreement agreement = new Agreement(SampleComponents.undecided(), List.of());
        assertThat(agreement.holds(100, LETTERS).transitionsTaken()).hasSize(3);
    }

    @Test
    void onErrorsOfTheModel() {
        List<Value> slices = List.of(new Value.IntegerValue(5));
        Agreement agreement = new Agreement(SampleComponents.timer(), slices);
        assertThat(agreement.holds(200, LETTERS).transitionsTaken()).hasSizeGreaterThan(2);
    }

    @Test
    void onANetworkWithPlatformComponents() {
        Agreement agreement = new Agreement(SampleComponents.whole(), List.of());
        assertThat(agreement.holds(200, LETTERS).transitionsTaken()).hasSizeGreaterThan(8);
    }

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> onTheModelsOfTheFolder() {
        return Scenario.in("agreement").stream().flatMap(file -> agreement(model(file), 40));
    }

    @TestFactory
    Stream<DynamicTest> onTheCaseStudy() {
        return agreement(Lowering.lower(Scenario.models("models/coffee")), 20);
    }

    private static Model model(Path file) {
        Workspace workspace = Scenario.read(file).workspace();
        assertThat(Checks.run(workspace, Profile.EXECUTABLE).stream().filter(Diagnostic::isError))
                .as(file.toString())
                .isEmpty();
        return Lowering.lower(workspace);
    }

    private static Stream<DynamicTest> agreement(Model model, int words) {
        return model.components().stream()
                .map(
                        component ->
                                DynamicTest.dynamicTest(
                                        component.qualifiedName(),
                                        () ->
                                                new Agreement(component, arguments(component))
                                                        .holds(words, LETTERS)));
    }

    private static List<Value> arguments(Component component) {
        List<Value> arguments = new ArrayList<>();
        Random random = new Random(component.parameters().size());
        component.parameters().forEach(p -> arguments.add(Agreement.value(p.type(), random)));
        return arguments;
    }
}
