package arcomat.maven;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * A small project that knows nothing of this build but a repository, built by the Maven of this
 * machine: once with a network, to have all that Maven needs, and from then on without.
 */
@Tag("slow")
class MavenShopTest {
    private static final Path MODELS = Path.of("../gradle/src/test/projects/shop/src");
    private static final Path POM = Path.of("src/test/projects/shop/pom.xml");

    /** Maven's own; what was fetched once stays. */
    private static final Path HOME = Path.of("build/maven-repository").toAbsolutePath();

    private static final String BUMPER = "src/main/arc/shop/Bumper.arc";
    private static final int SECONDS = 600;

    @TempDir private Path folder;

    /** What Maven printed. */
    private record Outcome(int status, String text) {}

    @BeforeAll
    static void resolveOnce(@TempDir Path first) throws IOException, InterruptedException {
        forget(HOME.resolve("arcomat")); // what this build has published by now
        copyShop(first);
        Outcome outcome;
        try {
            outcome = run(first, List.of("verify"));
        } catch (IOException none) {
            assumeTrue(false, "there is no mvn: " + none.getMessage());
            return;
        }
        assumeTrue(
                !outcome.text().contains("Could not transfer artifact"),
                "Maven cannot reach its repository");
        assertThat(outcome.status()).as(outcome.text()).isZero();
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
        String repository = Path.of(System.getProperty("repository")).toUri().toString();
        Files.writeString(
                folder.resolve("pom.xml"),
                Files.readString(POM)
                        .replace("@repository@", repository)
                        .replace("@version@", System.getProperty("version")));
    }

    private static void forget(Path folder) throws IOException {
        if (Files.exists(folder)) {
            try (Stream<Path> files = Files.walk(folder)) {
                for (Path each : files.sorted((a, b) -> b.compareTo(a)).toList()) {
                    Files.delete(each);
                }
            }
        }
    }

    private Outcome offline(String... arguments) throws IOException, InterruptedException {
        List<String> all = new ArrayList<>(List.of("--offline"));
        all.addAll(List.of(arguments));
        return run(folder, all);
    }

    private static Outcome run(Path folder, List<String> arguments)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("mvn", "--batch-mode", "-ntp"));
        command.add("-Dmaven.repo.local=" + HOME);
        String mirror = System.getenv("MAVEN_MIRROR_URL");
        if (mirror != null) {
            Path settings = folder.resolve("settings.xml");
            Files.writeString(settings, MIRROR.formatted(mirror));
            command.addAll(List.of("--settings", settings.toString()));
        }
        command.addAll(arguments);
        Path log = folder.resolve("log.txt");
        Process process =
                new ProcessBuilder(command)
                        .directory(folder.toFile())
                        .redirectErrorStream(true)
                        .redirectOutput(log.toFile())
                        .start();
        boolean ended = process.waitFor(SECONDS, TimeUnit.SECONDS);
        process.destroyForcibly();
        return new Outcome(ended ? process.exitValue() : -1, Files.readString(log));
    }

    private static final String MIRROR =
            """
            <settings>
              <mirrors>
                <mirror>
                  <id>mirror</id>
                  <url>%s</url>
                  <mirrorOf>central</mirrorOf>
                </mirror>
              </mirrors>
            </settings>
            """;

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
