package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The version stands in gradle.properties; what repeats it for people to copy says the same. */
class VersionTest {
    /** As in {@code arcomat-1.2.3.zip}, {@code id 'arcomat' version '1.2.3'}. */
    private static final Pattern NAMED =
            Pattern.compile(
                    "(?i)version\\D{0,5}(\\d+\\.\\d+\\.\\d+)|"
                            + "arcomat[-_:\\w]*[-_: ](\\d+\\.\\d+\\.\\d+)");

    @Test
    void pagesAndExamplesNameTheVersionOfThisBuild() throws IOException {
        Properties properties = new Properties();
        try (var reader = Files.newBufferedReader(Path.of("gradle.properties"))) {
            properties.load(reader);
        }
        String version = properties.getProperty("version");
        List<String> named = new ArrayList<>();
        for (Path file : repeating()) {
            Matcher matcher = NAMED.matcher(Files.readString(file));
            while (matcher.find()) {
                String found = matcher.group(1) == null ? matcher.group(2) : matcher.group(1);
                named.add(found);
                assertThat(found)
                        .as("%s: give it by ./gradlew nameVersion", file)
                        .isEqualTo(version);
            }
        }
        assertThat(named).hasSizeGreaterThan(10);
    }

    private static List<Path> repeating() throws IOException {
        List<Path> files =
                new ArrayList<>(
                        List.of(Path.of("README.md"), Path.of("models/coffee/settings.gradle")));
        try (Stream<Path> pages = Files.walk(Path.of("docs"))) {
            pages.filter(file -> file.toString().endsWith(".md")).forEach(files::add);
        }
        try (Stream<Path> guests = Files.list(Path.of("guests"))) {
            guests.map(guest -> guest.resolve("gradle.properties"))
                    .filter(Files::exists)
                    .forEach(files::add);
        }
        return files;
    }
}
