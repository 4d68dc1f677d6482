package arcomat.laws;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** Cases that have to come out right, {@code src/test/resources/laws}; {@link Cases} tells how. */
class CasesTest {
    private static final Path FOLDER = Path.of("verify/src/test/resources/laws");

    @TestFactory
    Stream<DynamicTest> cases() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.sorted().toList().stream().flatMap(CasesTest::ofFile);
        }
    }

    private static Stream<DynamicTest> ofFile(Path file) {
        try {
            Cases cases = Cases.read(file);
            return cases.head().stream()
                    .filter(Cases::isCase)
                    .map(
                            line ->
                                    DynamicTest.dynamicTest(
                                            file.getFileName() + " " + line,
                                            () -> cases.check(line)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
