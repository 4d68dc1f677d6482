package arcomat.pipeline.brick;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** What a manifest says, damaged or not; nothing is told about it on standard error. */
class JarReaderTest {
    private static Optional<String> read(String text) {
        return JarReader.mainClass(text.getBytes(StandardCharsets.UTF_8));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "Manifest-Version: 1.0\r\nMain-Class: p.Main\r\n\r\n",
                "Manifest-Version: 1.0\nMain-Class: p.Main\n",
                "main-class:p.Main",
                "Manifest-Version: 1.0\r\nMain-Class: p.\r\n Ma\r\n in\r\n\r\n",
                "X: 1\nX: 2\nno attribute\nMain-Class: p.Main\n\n"
            })
    void namesTheMainClass(String manifest) {
        assertThat(read(manifest)).contains("p.Main");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "Manifest-Version: 1.0\n",
                "Main-Cliss: p.Main\n",
                "Main-Class: \n",
                "Manifest-Version: 1.0\n\nName: p\nMain-Class: p.Main\n"
            })
    void namesNone(String manifest) {
        assertThat(read(manifest)).isEmpty();
    }

    @Test
    void isNoText() {
        assertThat(JarReader.mainClass(new byte[] {(byte) 0xff, 0, (byte) 0xc3})).isEmpty();
    }
}
