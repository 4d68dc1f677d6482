package arcomat.pipeline.file;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

class FailuresTest {
    @Test
    void aFileThatIsNoTextIsSaidToBeNone(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("proof.txt");
        Files.write(file, new byte[] {(byte) 0xff, (byte) 0xfe, 0});
        try {
            Files.readString(file);
        } catch (IOException e) {
            assertThat(Failures.reason(e)).isEqualTo("it is not text in UTF-8");
            return;
        }
        throw new AssertionError("it was read");
    }
}
