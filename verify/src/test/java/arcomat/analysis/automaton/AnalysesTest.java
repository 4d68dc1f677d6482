package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.DataFile;
import arcomat.check.Expectation;
import arcomat.models.ReadModels;
import arcomat.source.Diagnostic;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Each analysis against its data, {@code verify/src/test/resources/analyze/Overlap.arc}. What a
 * file does not expect fails, and so does what it expects in vain; and every witness is replayed.
 */
class AnalysesTest {
    private static final Path DATA = Path.of("verify/src/test/resources/analyze");
    private static final Path SOURCES = Path.of("verify/src/main/java/arcomat/analysis/automaton");
    private static final Path ACTUAL = Path.of("build/analyze-actual");

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> findsWhatTheDataFilesExpect() throws IOException {
        return dataFiles().stream()
                .map(path -> DynamicTest.dynamicTest(path.toString(), () -> compare(path)));
    }

    private static void compare(Path path) throws IOException {
        DataFile data = DataFile.read(path);
        List<Examination> examinations = Models.examine(ReadModels.model(data.files()));
        List<Expectation> actual =
                examinations.stream()
                        .flatMap(each -> each.findings().stream())
                        .map(Finding::diagnostic)
                        .sorted(Diagnostic.ORDER)
                        .map(Expectation::of)
                        .toList();
        if (!fits(data.expectations(), actual)) {
            Files.createDirectories(ACTUAL);
            String text = data.withExpectations(actual);
            Files.writeString(ACTUAL.resolve(path.getFileName()), text);
            assertThat(text).isEqualTo(data.withExpectations(data.expectations()));
        }
        examinations.forEach(Replay::all);
    }

    private static boolean fits(List<Expectation> expected, List<Expectation> actual) {
        List<Expectation> open = new ArrayList<>(actual);
        for (Expectation expectation : expected) {
            Expectation met = open.stream().filter(expectation::isMetBy).findFirst().orElse(null);
            if (!open.remove(met)) {
                return false;
            }
        }
        return open.isEmpty();
    }

    /**
     * In its own file an analysis finds something, in a component called bad, and not in others.
     */
    @TestFactory
    Stream<DynamicTest> everyAnalysisHasGoodAndBadExamples() throws IOException {
        return dataFiles().stream()
                .map(path -> DynamicTest.dynamicTest(path.toString(), () -> examples(path)));
    }

    private static void examples(Path path) throws IOException {
        DataFile data = DataFile.read(path);
        String code = code(name(path));
        List<Expectation> own =
                data.expectations().stream().filter(e -> e.code().equals(code)).toList();
        assertThat(own)
                .anyMatch(e -> !e.message().isEmpty())
                .allMatch(e -> e.path().contains("Bad"));
        assertThat(data.files()).anyMatch(file -> file.path().contains("Good"));
    }

    @Test
    void everyAnalysisIsListedAndHasDataAndAPage() throws IOException {
        List<String> classes = analysisClasses();
        assertThat(dataFiles().stream().map(AnalysesTest::name)).containsExactlyElementsOf(classes);
        assertThat(Analyses.ALL).hasSameSizeAs(classes);
        assertThat(classes.stream().map(AnalysesTest::code)).doesNotHaveDuplicates();
        for (String each : classes) {
            Path page = Path.of("src/main/resources/explain", code(each) + ".md");
            assertThat(page).content().startsWith("# " + code(each) + " ");
        }
    }

    private static List<String> analysisClasses() throws IOException {
        try (Stream<Path> files = Files.list(SOURCES)) {
            return files.map(AnalysesTest::name).filter(AnalysesTest::isAnalysis).sorted().toList();
        }
    }

    private static boolean isAnalysis(String name) {
        try {
            Class<?> type = Class.forName("arcomat.analysis.automaton." + name);
            return Analysis.class.isAssignableFrom(type)
                    && type != OutsideAnalysis.class // asks what others bring
                    && !java.lang.reflect.Modifier.isAbstract(type.getModifiers());
        } catch (ClassNotFoundException notAClass) {
            return false;
        }
    }

    private static String code(String name) {
        try {
            return (String)
                    Class.forName("arcomat.analysis.automaton." + name)
                            .getDeclaredField("CODE")
                            .get(null);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(e);
        }
    }

    private static String name(Path path) {
        return path.getFileName().toString().replaceFirst("\\..*", "");
    }

    private static List<Path> dataFiles() throws IOException {
        try (Stream<Path> files = Files.list(DATA)) {
            return files.sorted().toList();
        }
    }
}
