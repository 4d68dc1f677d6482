package arcomat.analysis.game.controller;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Sections;
import arcomat.analysis.Sections.Section;
import arcomat.analysis.contradiction.Contradictions;
import arcomat.analysis.search.Budget;
import arcomat.generate.ControllerText;
import arcomat.generate.GeneratedFile;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Controllers as text: the tool reads it, finds nothing wrong, generates code from it, and it means
 * the same. What stands below {@code == controller C} is the expected text.
 */
class ControllerTextTest {
    private static final Path FOLDER = Path.of("verify/src/test/resources/analysis/contradictions");
    private static final Budget BUDGET = new Budget(() -> false, 100_000);

    @TestFactory
    Stream<DynamicTest> controllers() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.sorted().toList().stream().flatMap(ControllerTextTest::ofFile);
        }
    }

    private static Stream<DynamicTest> ofFile(Path path) {
        Sections sections = Sections.read(path);
        Model model = sections.model();
        return sections.of("controller").stream()
                .map(
                        section ->
                                DynamicTest.dynamicTest(
                                        path.getFileName() + " " + section.rest(),
                                        () -> check(sections, model, section)));
    }

    private static void check(Sections sections, Model model, Section expected) {
        Component component = model.component(expected.rest()).orElseThrow();
        Promise promise =
                component.isComposite()
                        ? Promise.required(component, List.of())
                        : Promise.of(component, List.of());
        Component controller =
                Contradictions.check(promise, false, BUDGET).controller().orElseThrow();
        SourceFile file = ControllerReading.text(controller, component);
        assertThat(file.text().lines().filter(line -> !line.isBlank()))
                .containsExactlyElementsOf(expected.lines());
        List<SourceFile> models = new ArrayList<>(sections.sources());
        if (component.isComposite()) {
            models.add(requirements(component, controller));
        }
        ControllerReading.check(models, file, controller);
    }

    private static SourceFile requirements(Component component, Component controller) {
        String name = controller.refines().get(0);
        GeneratedFile file = ControllerText.required(component, name, List.of(), List.of("Asks."));
        return new SourceFile(file.path(), file.text());
    }
}
