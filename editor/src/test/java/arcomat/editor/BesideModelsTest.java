package arcomat.editor;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** In the worlds, campaigns and scripts that are shipped nothing is wrong. */
class BesideModelsTest {
    private static final Path MODELS = Path.of("models/coffee");

    @Tag("slow")
    @Test
    void shippedOnes() throws IOException {
        List<String> texts = texts();
        assertThat(texts).hasSizeGreaterThan(8);
        try (EditorClient client = new EditorClient(MODELS.toRealPath())) {
            for (String text : texts) {
                client.open(text);
            }
            assertThat(client.problems()).isEmpty();
        }
    }

    private static List<String> texts() throws IOException {
        try (Stream<Path> files = Files.walk(MODELS)) {
            return files.map(MODELS::relativize)
                    .map(file -> file.toString().replace('\\', '/'))
                    .filter(file -> !file.startsWith("build/"))
                    .filter(BesideModelsTest::isBesideModels)
                    .sorted()
                    .toList();
        }
    }

    private static boolean isBesideModels(String file) {
        return Stream.of(".world", ".campaign", ".script").anyMatch(file::endsWith);
    }
}
