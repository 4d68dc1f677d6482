package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.report.finding.SarifSchema;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** Whatever a session prints as SARIF is valid against the schema. */
class SarifSessionsTest {
    private static final Path FOLDER = Path.of("cli/src/test/resources/cli");

    @TestFactory
    List<DynamicTest> everySarifTextIsValid() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        try (Stream<Path> files = Files.list(FOLDER)) {
            for (Path file : (Iterable<Path>) files.sorted()::iterator) {
                for (Transcript.Section section : sections(file)) {
                    String name = file.getFileName() + ": " + section.rest();
                    tests.add(DynamicTest.dynamicTest(name, () -> validate(section)));
                }
            }
        }
        assertThat(tests).hasSizeGreaterThan(4);
        return tests;
    }

    private static List<Transcript.Section> sections(Path file) throws IOException {
        return Transcript.parse(Files.readAllLines(file)).sections().stream()
                .filter(Transcript.Section::isCommand)
                .filter(section -> section.rest().contains("--format sarif"))
                .toList();
    }

    private static void validate(Transcript.Section section) {
        List<String> body = section.body();
        assertThat(SarifSchema.problems(String.join("\n", body.subList(0, body.size() - 1))))
                .isEmpty();
    }
}
