package arcomat.generate;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;

/**
 * Generated code is Java 6, and code of every Java since: the golden files compile at the releases
 * that the compiler at hand knows, and keep the rules of a later one.
 */
class NewerJavaTest {
    private static final Path GOLDEN = Path.of("src/test/resources/golden");
    private static final List<String> RELEASES = List.of("8", "11", "17");
    private static final Pattern NO_CODE =
            Pattern.compile(
                    "(?s)/\\*.*?\\*/|//[^\\n]*|\"(?:\\\\.|[^\"\\\\])*\"|'(?:\\\\.|[^'\\\\])*'");

    /** Up to Java 21: no name at all, no name of a type, no name of a method that is called. */
    private static final Pattern FORBIDDEN =
            Pattern.compile(
                    "(?<![\\w$])_(?![\\w$])"
                        + "|\\b(?:class|enum|interface)\\s+(?:permits|record|sealed|var|yield)\\b"
                        + "|(?<![\\w$.])yield\\s*\\(|(?<![\\w$.])(?:assert|enum)\\s*[=;,)]");

    @TestFactory
    Stream<DynamicTest> compilesAtEachRelease() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path folder : folders()) {
            for (String release : RELEASES) {
                tests.add(
                        DynamicTest.dynamicTest(
                                folder + " at " + release, () -> compile(folder, release)));
            }
        }
        return tests.stream();
    }

    @TestFactory
    Stream<DynamicTest> keepsTheRulesOfALaterRelease() throws IOException {
        return folders().stream()
                .map(folder -> DynamicTest.dynamicTest(folder.toString(), () -> look(folder)));
    }

    private static void look(Path folder) throws IOException {
        for (Path file : sources(folder)) {
            String code = NO_CODE.matcher(Files.readString(file)).replaceAll(" ");
            assertThat(code).as(file.toString()).doesNotContainPattern(FORBIDDEN);
        }
    }

    private static void compile(Path folder, String release) throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        Path classes = Files.createTempDirectory("newer");
        StringWriter said = new StringWriter();
        List<String> options =
                List.of(
                        "--release",
                        release,
                        "-proc:none",
                        "-Xlint:none",
                        "-d",
                        classes.toString());
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, null)) {
            boolean fine =
                    compiler.getTask(
                                    said,
                                    files,
                                    null,
                                    options,
                                    null,
                                    files.getJavaFileObjectsFromPaths(sources(folder)))
                            .call();
            assertThat(fine).as("%s at %s: %s", folder, release, said).isTrue();
        } finally {
            delete(classes);
        }
    }

    /** Each holds what was generated at once; what is for the brick needs the brick. */
    private static List<Path> folders() throws IOException {
        List<Path> folders = new ArrayList<>();
        for (String kind : List.of("jvm", "monitor")) {
            try (Stream<Path> paths = Files.list(GOLDEN.resolve(kind))) {
                paths.filter(Files::isDirectory).sorted().forEach(folders::add);
            }
        }
        return folders;
    }

    private static List<Path> sources(Path folder) throws IOException {
        try (Stream<Path> paths = Files.walk(folder)) {
            return paths.filter(path -> path.toString().endsWith(".java")).sorted().toList();
        }
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> paths = Files.walk(folder)) {
            for (Path path : paths.sorted((a, b) -> b.compareTo(a)).toList()) {
                Files.delete(path);
            }
        }
    }
}
