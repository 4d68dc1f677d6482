package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The guest that the page writes step by step is the one that is built as an example. */
class GuestsPageTest {
    @Test
    void theLanguageOnThePageIsTheExample() throws IOException {
        Fence shown =
                Fence.of(Path.of("docs/guests.md")).stream()
                        .filter(fence -> fence.title().equals("blink/Blink.java"))
                        .findFirst()
                        .orElseThrow();
        assertThat(Path.of("guests/blink/src/main/java/blink/Blink.java"))
                .hasContent(shown.text())
                .satisfies(file -> assertThat(Files.readAllLines(file)).hasSizeLessThan(150));
    }
}
