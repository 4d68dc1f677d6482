package arcomat.fuzz.process;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** What {@code ./gradlew installDist} makes. */
final class Installation {
    private static final Path PLACE = Path.of("build/install/arcomat").toAbsolutePath();

    private Installation() {}

    static Path command() {
        return PLACE.resolve("bin/arcomat");
    }

    /** Its jars. */
    static List<Path> libraries() throws IOException {
        try (Stream<Path> files = Files.list(PLACE.resolve("lib"))) {
            return files.filter(file -> file.toString().endsWith(".jar"))
                    .sorted()
                    .collect(Collectors.toList());
        }
    }
}
