package arcomat.editor;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.editor.answer.completion.Completion;
import arcomat.editor.answer.fact.HoverCard;
import arcomat.editor.answer.fact.InlineFacts;
import arcomat.editor.answer.fact.ParameterHelp;
import arcomat.editor.answer.flow.ConnectorHierarchy;
import arcomat.editor.answer.shape.DocumentOutline;
import arcomat.editor.answer.shape.Folds;
import arcomat.editor.answer.shape.NameColours;
import arcomat.editor.answer.shape.Selections;
import arcomat.editor.desk.View;
import arcomat.editor.text.Positions;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.SourceFile;

import org.eclipse.lsp4j.DocumentSymbol;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** Every beginning of a model has answers: nobody writes a model in one stroke. */
class HalfWrittenTest {
    private static final Path ROOT = Path.of("models/coffee");

    /** Every prefix would take minutes; with a step that is prime, no column is left out. */
    private static final int STEP = 13;

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> beginnings() throws IOException {
        OpenModels all = models();
        return all.paths().stream()
                .filter(path -> !all.isLibrary(path))
                .map(path -> DynamicTest.dynamicTest(path, () -> everyBeginning(all, path)));
    }

    private static OpenModels models() throws IOException {
        List<SourceFile> sources = new ArrayList<>();
        try (Stream<Path> files = Files.walk(ROOT.resolve("coffee"))) {
            for (Path file : files.filter(HalfWrittenTest::isModel).sorted().toList()) {
                String path = ROOT.relativize(file).toString().replace('\\', '/');
                sources.add(new SourceFile(path, Files.readString(file)));
            }
        }
        return OpenModels.in(ROOT.toAbsolutePath(), false).with(OpenModels.Edit.of(sources));
    }

    private static boolean isModel(Path file) {
        return Stream.of(".arc", ".cd", ".mt").anyMatch(file.toString()::endsWith);
    }

    private static void everyBeginning(OpenModels all, String path) {
        String text = all.source(path).orElseThrow().text();
        for (int end = 0; end <= text.length(); end += STEP) {
            SourceFile beginning = new SourceFile(path, text.substring(0, end));
            OpenModels models = all.with(OpenModels.Edit.of(List.of(beginning)));
            View view =
                    new View(
                            models,
                            beginning,
                            models.parsed(path).orElseThrow(),
                            each -> models.root().resolve(each));
            assertThat(Completion.at(view, end)).doesNotContainNull();
            shapeAndFacts(view, end);
        }
    }

    private static void shapeAndFacts(View view, int end) {
        Position place = Positions.position(view.file(), end);
        assertThat(DocumentOutline.of(view)).allSatisfy(HalfWrittenTest::isNested);
        assertThat(Folds.of(view))
                .allSatisfy(
                        each -> assertThat(each.getEndLine()).isGreaterThan(each.getStartLine()));
        assertThat(Selections.at(view, List.of(place))).doesNotContainNull();
        assertThat(NameColours.of(view).getData())
                .allSatisfy(each -> assertThat(each).isNotNegative());
        assertThat(InlineFacts.in(view, Positions.all(view.file()))).doesNotContainNull();
        assertThat(ConnectorHierarchy.prepare(view, place)).doesNotContainNull();
        HoverCard.at(view, place).ifPresent(each -> assertThat(each.getContents()).isNotNull());
        ParameterHelp.at(view, end).ifPresent(each -> assertThat(each.getSignatures()).hasSize(1));
    }

    /** As the protocol asks: a name lies in its declaration, that in the one around. */
    private static void isNested(DocumentSymbol symbol) {
        assertThat(symbol.getName()).isNotEmpty();
        assertThat(isIn(symbol.getSelectionRange(), symbol.getRange())).isTrue();
        assertThat(symbol.getChildren())
                .allSatisfy(
                        each -> {
                            assertThat(isIn(each.getRange(), symbol.getRange())).isTrue();
                            isNested(each);
                        });
    }

    private static boolean isIn(Range inner, Range outer) {
        return !isBefore(inner.getStart(), outer.getStart())
                && !isBefore(outer.getEnd(), inner.getEnd());
    }

    private static boolean isBefore(Position one, Position other) {
        return one.getLine() < other.getLine()
                || one.getLine() == other.getLine() && one.getCharacter() < other.getCharacter();
    }
}
