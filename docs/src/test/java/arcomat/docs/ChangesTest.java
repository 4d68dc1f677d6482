package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** What changes say to users: what is different, and what they see of it. */
class ChangesTest {
    private static final Path CHANGES = Path.of("changes");
    private static final String NAME = "(added|changed|fixed)(-[a-z0-9]+)+\\.md";

    @Test
    void everyChangeSaysWhatIsDifferentAndShowsIt() throws IOException {
        for (Path change : changes()) {
            assertThat(change.getFileName().toString()).matches(NAME);
            List<String> paragraphs = List.of(Files.readString(change).strip().split("\n\n"));
            assertThat(paragraphs.get(0))
                    .as("%s says what is different", change)
                    .doesNotStartWith("```");
            assertThat(paragraphs)
                    .as("%s shows what a user sees", change)
                    .anyMatch(each -> each.startsWith("```"));
            assertThat(Files.readAllLines(change)).as("%s", change).hasSizeLessThanOrEqualTo(30);
        }
    }

    private static List<Path> changes() throws IOException {
        try (Stream<Path> files = Files.list(CHANGES)) {
            return files.filter(file -> !file.endsWith("README.md")).sorted().toList();
        }
    }
}
