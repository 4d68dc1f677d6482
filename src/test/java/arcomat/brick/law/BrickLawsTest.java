package arcomat.brick.law;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.BrickCheck;
import arcomat.brick.BrickCompiler;
import arcomat.brick.BrickReport;
import arcomat.brick.Robots;
import arcomat.check.DataFile;
import arcomat.check.Expectation;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Laws against Java files that say below a line what is wrong with it: {@code
 * src/test/resources/brick/NoInvokeDynamic.java}. A file that starts with {@code // java: 8} is
 * compiled against the JDK, as a careless team would; others as the product does it.
 */
class BrickLawsTest {
    private static final Path DATA = Path.of("src/test/resources/brick");
    private static final Path EXPLAIN = Path.of("src/main/resources/explain");
    private static final Path ACTUAL = Path.of("build/brick-actual");
    private static final Path CLASSES = Path.of("src/main/java/arcomat/brick/law");

    @TempDir static Path folder;
    private static BrickCompiler compiler;

    @BeforeAll
    static void writeStubJar() {
        compiler = new BrickCompiler(folder);
    }

    @TestFactory
    List<DynamicTest> findsWhatTheDataFilesExpect() throws IOException {
        try (Stream<Path> files = Files.list(DATA)) {
            return files.sorted()
                    .map(path -> DynamicTest.dynamicTest(name(path), () -> compare(path)))
                    .toList();
        }
    }

    private static void compare(Path path) throws IOException {
        DataFile data = DataFile.read(path);
        SourceFile[] sources = data.files().toArray(new SourceFile[0]);
        boolean againstJdk = Files.readString(path).startsWith("// java: 8\n");
        Map<String, byte[]> classes =
                (againstJdk ? compiler.forJava(8, sources) : compiler.forBrick(sources)).orFail();

        BrickReport report = BrickCheck.check(Robots.jar(classes, data.files()), Robots.TABLE);

        List<Expectation> actual = report.findings().stream().map(Expectation::of).toList();
        assertThat(actual(path, data.withExpectations(actual)))
                .isEqualTo(data.withExpectations(data.expectations()));
        assertThat(actual).as("findings of the law").anyMatch(e -> e.code().equals(code(path)));
    }

    /** Keeps what was found, in the form of the data file, to be compared and copied. */
    private static String actual(Path path, String text) throws IOException {
        Files.createDirectories(ACTUAL);
        Files.writeString(ACTUAL.resolve(path.getFileName()), text);
        return text;
    }

    private static String code(Path path) {
        return BrickLaws.ALL.stream()
                .filter(law -> law.getClass().getSimpleName().equals(name(path)))
                .map(BrickLaw::code)
                .findFirst()
                .orElseThrow();
    }

    private static String name(Path path) {
        return path.getFileName().toString().replace(".java", "");
    }

    @Test
    void everyLawIsListedOnceInAlphabeticalOrder() throws IOException {
        List<String> listed =
                BrickLaws.ALL.stream().map(law -> law.getClass().getSimpleName()).toList();

        assertThat(listed).isSorted().doesNotHaveDuplicates();
        try (Stream<Path> files = Files.list(CLASSES)) {
            assertThat(
                            files.filter(Files::isRegularFile)
                                    .filter(BrickLawsTest::isLaw)
                                    .map(BrickLawsTest::name))
                    .containsExactlyInAnyOrderElementsOf(listed);
        }
    }

    private static boolean isLaw(Path path) {
        try {
            return Files.readString(path)
                    .matches("(?s).*\\nfinal class \\w+ extends (BrickLaw|Limit) \\{.*");
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    @Test
    void everyCodeIsUsedOnceAndExplained() {
        assertThat(BrickLaws.ALL.stream().map(BrickLaw::code))
                .doesNotHaveDuplicates()
                .allMatch(code -> code.matches("ARC09\\d\\d"))
                .allSatisfy(
                        code ->
                                assertThat(EXPLAIN.resolve(code + ".md"))
                                        .content()
                                        .startsWith("# " + code + " "));
    }
}
