package arcomat.pipeline.check;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Path;

class LibraryFolderTest {
    @Test
    void allModelsAreThereAsTheyAre() throws IOException {
        Path folder = LibraryFolder.written();
        assertThat(Library.texts()).isNotEmpty();
        Library.texts()
                .forEach(
                        (path, text) -> {
                            assertThat(folder.resolve(path)).hasContent(text);
                            assertThat(LibraryFolder.holds(folder.resolve(path))).isTrue();
                        });
        assertThat(LibraryFolder.written()).isEqualTo(folder);
    }

    @Test
    void otherFilesAreNoneOfIt() {
        assertThat(LibraryFolder.holds(Path.of("models/sprint/sprint/LineRunner.arc"))).isFalse();
    }
}
