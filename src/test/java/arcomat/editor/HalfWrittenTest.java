package arcomat.editor;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.editor.answer.completion.Completion;
import arcomat.editor.desk.View;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.DynamicTest;
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
        }
    }
}
