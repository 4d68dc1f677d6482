package arcomat.maven;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.maven.Maven.Outcome;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** A guest that one module makes takes part in the checks of the next one. */
@Tag("build")
class MavenGuestsTest {
    private static final Path LAB = Path.of("../../guests/lab/src/main");
    private static final Path CART = Path.of("../../guests/lab/src/test/arc/floor/Cart.arc");

    private static final String API =
            """
              <dependencies>
                <dependency>
                  <groupId>arcomat</groupId>
                  <artifactId>arcomat-api</artifactId>
                  <version>%s</version>
                  <scope>provided</scope>
                </dependency>
              </dependencies>
            """;

    private static final String GUEST =
            """
                    <dependencies>
                      <dependency>
                        <groupId>shop</groupId>
                        <artifactId>rules</artifactId>
                        <version>1</version>
                      </dependency>
                    </dependencies>
            """;

    @TempDir private Path folder;

    @BeforeAll
    static void resolveOnce(@TempDir Path first) throws IOException, InterruptedException {
        write(first);
        Maven.resolveOnce(first);
    }

    @BeforeEach
    void setUp() throws IOException {
        write(folder);
    }

    private static void write(Path folder) throws IOException {
        Files.writeString(folder.resolve("pom.xml"), Maven.modules("rules", "robot"));
        String pom = Maven.pom("robot");
        copy(LAB, folder.resolve("rules/src/main"));
        Files.writeString(folder.resolve("rules/pom.xml"), rules());
        Path cart = folder.resolve("robot/src/main/arc/floor/Cart.arc");
        Files.createDirectories(cart.getParent());
        Files.copy(CART, cart);
        String plugin = "<artifactId>arcomat-maven-plugin</artifactId>";
        int end = pom.indexOf("<executions>", pom.indexOf(plugin));
        Files.writeString(
                folder.resolve("robot/pom.xml"),
                pom.substring(0, end) + GUEST.strip() + "\n        " + pom.substring(end));
    }

    /** Without models, and so without our plugin. */
    private static String rules() throws IOException {
        String api = API.formatted(System.getProperty("version"));
        return Maven.pom("rules")
                .replaceFirst("(?s)  <dependencies>.*?</dependencies>\n", api)
                .replaceFirst("(?s)  <build>.*?</build>\n", "");
    }

    private static void copy(Path from, Path to) throws IOException {
        try (Stream<Path> files = Files.walk(from)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Path copy = to.resolve(from.relativize(file).toString());
                Files.createDirectories(copy.getParent());
                Files.copy(file, copy);
            }
        }
    }

    @Test
    void aDependencyOfThePluginThatIsAGuestTakesPart() throws Exception {
        Outcome built = Maven.offline(folder, "verify");
        assertThat(built.status()).as(built.text()).isZero();
        assertThat(Files.readString(folder.resolve("robot/target/arcomat/check.txt")))
                .contains("warning LAB0001")
                .contains("(guest 'lab')");
    }
}
