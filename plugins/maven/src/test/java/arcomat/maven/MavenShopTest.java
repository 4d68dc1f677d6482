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
import java.nio.file.attribute.FileTime;
import java.util.stream.Stream;

/**
 * A small project that knows nothing of this build but a repository, built by the Maven of this
 * machine: once with a network, to have all that Maven needs, and from then on without.
 */
@Tag("build")
class MavenShopTest {
    private static final Path MODELS = Path.of("../gradle/src/test/projects/shop/src");
    private static final String BUMPER = "src/main/arc/shop/Bumper.arc";

    @TempDir private Path folder;

    @BeforeAll
    static void resolveOnce(@TempDir Path first) throws IOException, InterruptedException {
        copyShop(first);
        Maven.resolveOnce(first);
    }

    @BeforeEach
    void setUp() throws IOException {
        copyShop(folder);
    }

    private static void copyShop(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(MODELS)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                Path copy = folder.resolve("src").resolve(MODELS.relativize(file).toString());
                Files.createDirectories(copy.getParent());
                Files.copy(file, copy);
            }
        }
        Files.writeString(folder.resolve("pom.xml"), Maven.pom());
    }

    private Outcome offline(String... arguments) throws IOException, InterruptedException {
        return Maven.offline(folder, arguments);
    }

    private void edit(String name, String old, String fresh) throws IOException {
        String text = Files.readString(folder.resolve(name));
        assertThat(text).contains(old);
        Files.writeString(folder.resolve(name), text.replace(old, fresh));
    }

    private String read(String name) throws IOException {
        return Files.readString(folder.resolve(name));
    }

    @Test
    void modelsAreAPartOfTheBuild() throws Exception {
        Outcome built = offline("verify");
        assertThat(built.status()).as(built.text()).isZero();
        assertThat(built.text())
                .contains("no findings in 5 files")
                .contains("1 passed (1 vacuous), 0 failed")
                .contains("BUILD SUCCESS");
        assertThat(read("target/arcomat/check.txt")).isEqualTo("no findings in 5 files\n");
        assertThat(read("target/surefire-reports/TEST-arc.xml")).contains("<testcase");
        assertThat(folder.resolve("target/classes/shop/logic/Bumper.class")).exists();
        assertThat(folder.resolve("target/classes/shop/Lap.class")).exists();
        assertThat(folder.resolve("target/nxt/Rover.jar")).exists();
    }

    @Test
    void whatHasNotChangedIsNotCompiledAgain() throws Exception {
        assertThat(offline("compile").text()).contains("Compiling ");
        Path code = folder.resolve("target/generated-sources/arcomat/shop/logic");
        FileTime first = Files.getLastModifiedTime(code.resolve("Bumper.java"));
        assertThat(offline("compile").text()).contains("Nothing to compile");

        edit("src/main/arc/shop/Gear.arc", "speed = 360", "speed = 180");
        assertThat(offline("compile").text()).contains("Compiling ");
        assertThat(Files.getLastModifiedTime(code.resolve("Bumper.java"))).isEqualTo(first);
        assertThat(read("target/generated-sources/arcomat/shop/logic/Gear.java")).contains("180");

        Files.delete(folder.resolve("src/main/arc/shop/Rover.arc"));
        Files.delete(folder.resolve("src/main/arc/shop/Gear.arc"));
        assertThat(offline("compile").status()).isZero();
        assertThat(code.resolve("Bumper.java")).exists();
        assertThat(code.resolve("Gear.java")).doesNotExist();
    }

    @Test
    void aFindingFailsTheBuildAndNotMavensProcess() throws Exception {
        edit(BUMPER, "standing -> driving", "standing -> drivin");
        Outcome failed = offline("compile");
        assertThat(failed.status()).isEqualTo(1);
        assertThat(failed.text())
                .contains(BUMPER + ":15:21: error ARC0304")
                .contains("1 error in 5 files")
                .contains("BUILD FAILURE") // said by Maven, which is still there
                .doesNotContain("Exception:");
        assertThat(folder.resolve("target/generated-sources/arcomat")).doesNotExist();
    }

    @Test
    void aTestThatFailsFailsTheBuild() throws Exception {
        edit("src/test/arc/shop/BumperTest.mt", "Tk, halt, Tk", "Tk, go, Tk");
        Outcome failed = offline("test");
        assertThat(failed.status()).isEqualTo(1);
        assertThat(failed.text()).contains("FAILED stops").contains("0 passed, 1 failed");
        assertThat(offline("test", "-DskipTests").status()).isZero();
    }

    @Test
    void aGoalAloneAndASettingOfTheCommandLine() throws Exception {
        Outcome wrong = offline("arcomat:check", "-Darcomat.profile=perfect");
        assertThat(wrong.status()).isEqualTo(1);
        assertThat(wrong.text()).contains("--profile").contains("perfect");
        assertThat(offline("arcomat:check", "-Darcomat.skip").text())
                .contains("left out, as arcomat.skip says");
    }
}
