package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Gradle compares every library with the checksum that was written down, as long as there is one
 * for it and verification is on: here and in the builds that are started in folders of their own.
 */
class VerifiedDependenciesTest {
    private static final Path CHECKSUMS = Path.of("gradle/verification-metadata.xml");

    @Test
    void libraryHasTheChecksumThatIsWrittenDown() throws Exception {
        String text = Files.readString(CHECKSUMS);
        assertThat(text).contains("<verify-metadata>true</verify-metadata>");
        List<Path> others =
                DistributedJars.all().stream()
                        .filter(jar -> !jar.getFileName().toString().startsWith("arcomat-"))
                        .toList();
        assertThat(others).isNotEmpty();
        for (Path jar : others) {
            assertThat(text)
                    .containsPattern(
                            "artifact name=\"%s\">\\s*<sha256 value=\"%s\""
                                    .formatted(jar.getFileName(), DistributedJars.sha256(jar)));
        }
    }

    /** A build takes only the file in its own folder. */
    @Test
    void buildOfTheCoffeeRobotsGoesByTheSame() throws IOException {
        assertThat(Path.of("models/coffee").resolve(CHECKSUMS)).hasSameTextualContentAs(CHECKSUMS);
    }
}
