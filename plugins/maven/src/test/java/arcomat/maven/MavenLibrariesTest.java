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
import java.util.List;
import java.util.jar.JarFile;
import java.util.zip.ZipEntry;

/**
 * Models as artifacts: those of one project refer to those of another one, whose jar has the code.
 */
@Tag("build")
class MavenLibrariesTest {
    private static final Path MODELS =
            Path.of("../gradle/src/test/projects/shop/src/main/arc/shop");
    private static final String BUMPER = "parts/src/main/arc/shop/Bumper.arc";

    private static final String PARTS =
            """
              <dependencies>
                <dependency>
                  <groupId>shop</groupId>
                  <artifactId>parts</artifactId>
                  <version>1</version>
                </dependency>
                <dependency>
                  <groupId>shop</groupId>
                  <artifactId>parts</artifactId>
                  <version>1</version>
                  <classifier>models</classifier>
                </dependency>
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
        Files.writeString(folder.resolve("pom.xml"), Maven.modules("parts", "robot"));
        for (String model : List.of("Bumper.arc", "Gear.arc", "Shop.cd")) {
            copy(model, folder.resolve("parts"));
        }
        copy("Rover.arc", folder.resolve("robot"));
        Files.writeString(
                folder.resolve("parts/pom.xml"),
                Maven.pom("parts").replace("<goal>jar</goal>", "<goal>models</goal>"));
        Files.writeString(
                folder.resolve("robot/pom.xml"),
                Maven.pom("robot").replaceFirst("  <dependencies>\n", PARTS));
    }

    private static void copy(String model, Path project) throws IOException {
        Path root = project.resolve("src/main/arc/shop");
        Files.createDirectories(root);
        Files.copy(MODELS.resolve(model), root.resolve(model));
    }

    @Test
    void codeOfOthersComesByTheirJar() throws Exception {
        edit("Boolean wall", "Boolean Wall");
        edit("{wall ==", "{Wall ==");
        Path rover = folder.resolve("robot/src/main/arc/shop/Rover.arc");
        Files.writeString(rover, Files.readString(rover).replace("bumper.wall", "bumper.Wall"));

        Outcome built = Maven.offline(folder, "verify");
        assertThat(built.status()).as(built.text()).isZero();
        assertThat(read("parts/target/arcomat/check.txt")).contains("ARC0210");
        assertThat(read("robot/target/arcomat/check.txt")).isEqualTo("no findings in 1 file\n");
        assertThat(entries("robot/target/robot-1.jar"))
                .anyMatch(name -> name.matches("shop/\\w+/Rover.class"))
                .noneMatch(entries("parts/target/parts-1.jar")::contains);
        assertThat(entries("parts/target/parts-1.jar")).contains("shop/logic/Bumper.class");
        assertThat(entries("robot/target/nxt/Rover.jar")).contains("shop/logic/Bumper.class");
        assertThat(entries("parts/target/parts-1-models.jar"))
                .containsExactly("shop/Bumper.arc", "shop/Gear.arc", "shop/Shop.cd");
    }

    @Test
    void aChangeOfAModelIsSeenByThoseThatReferToIt() throws Exception {
        assertThat(Maven.offline(folder, "compile").status()).isZero();
        edit("out Command wheels", "out Boolean wheels");
        edit("wheels = go", "wheels = true");
        edit("wheels = halt", "wheels = false");

        Outcome failed = Maven.offline(folder, "compile");
        assertThat(failed.status()).isEqualTo(1);
        assertThat(failed.text())
                .contains("robot/src/main/arc/shop/Rover.arc:16:30: error ARC0106")
                .contains("1 error in 1 file");
    }

    private void edit(String old, String fresh) throws IOException {
        String text = read(BUMPER);
        assertThat(text).contains(old);
        Files.writeString(folder.resolve(BUMPER), text.replace(old, fresh));
    }

    private String read(String name) throws IOException {
        return Files.readString(folder.resolve(name));
    }

    /** Without folders, and what each jar says of itself. */
    private List<String> entries(String jar) throws IOException {
        try (JarFile file = new JarFile(folder.resolve(jar).toFile())) {
            return file.stream()
                    .filter(entry -> !entry.isDirectory())
                    .map(ZipEntry::getName)
                    .filter(name -> !name.startsWith("META-INF/"))
                    .sorted()
                    .toList();
        }
    }
}
