package arcomat.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Sections.Section;
import arcomat.analysis.Verdict.Answer;
import arcomat.check.Checks;
import arcomat.check.Profile;
import arcomat.generate.Choosing;
import arcomat.generate.ControllerText;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Formatter;
import arcomat.syntax.Parser;
import arcomat.tree.Unit;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Controllers as text: the tool reads it, finds nothing wrong, generates code from it, and it means
 * the same. What stands below {@code == controller C} is the expected text.
 */
class ControllerTextTest {
    private static final Path FOLDER = Path.of("src/test/resources/analysis/contradictions");
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
        SourceFile file = text(controller, component);
        assertThat(file.text().lines().filter(line -> !line.isBlank()))
                .containsExactlyElementsOf(expected.lines());
        Component read = read(sections, file, controller.qualifiedName());
        means(read, controller);
        means(controller, read);
        Generation generation =
                Generator.generate(
                        Request.library(read, Choosing.FIRST), Target.shipped("jvm").orElseThrow());
        assertThat(generation.findings()).isEmpty();
        assertThat(generation.files()).isNotEmpty();
    }

    private static SourceFile text(Component controller, Component required) {
        GeneratedFile written =
                ControllerText.of(
                        controller, List.of("Keeps what " + required.name() + " requires."));
        SourceFile file = new SourceFile(written.path(), written.text());
        String formatted = Formatter.format(file).text().orElseThrow();
        return new SourceFile(written.path(), formatted);
    }

    private static Component read(Sections sections, SourceFile file, String name) {
        List<SourceFile> sources = new ArrayList<>(sections.sources());
        sources.add(file);
        List<Unit> units =
                sources.stream().map(each -> Parser.parse(each).unit().orElseThrow()).toList();
        Workspace workspace = Workspace.of(units, Set.of());
        List<Diagnostic> findings =
                Checks.run(workspace, Profile.EXECUTABLE).stream()
                        .filter(finding -> finding.span().file().path().equals(file.path()))
                        .toList();
        assertThat(findings).isEmpty();
        return Lowering.lower(workspace).component(name).orElseThrow();
    }

    private static void means(Component one, Component other) {
        Verdict verdict =
                Refinement.check(Promise.of(one, List.of()), Promise.of(other, List.of()), BUDGET);
        assertThat(verdict.answer()).isEqualTo(Answer.HOLDS);
    }
}
