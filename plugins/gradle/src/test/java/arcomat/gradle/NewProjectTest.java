package arcomat.gradle;

import static arcomat.gradle.ConsumerProject.outcomes;

import static org.assertj.core.api.Assertions.assertThat;

import org.gradle.testkit.runner.BuildResult;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Path;

/** What {@code arcomat new} makes is built as it is, with what is published. */
@Tag("build")
class NewProjectTest {
    @TempDir private Path folder;

    @ParameterizedTest
    @CsvSource({"robot, true", "component, false", "world, true"})
    void isBuiltAsItIs(String kind, boolean drives) throws Exception {
        create(kind);
        ConsumerProject project = ConsumerProject.publishedHere(folder.resolve("mower"));
        String mirror = System.getenv("MAVEN_MIRROR_URL");
        if (mirror != null) { // that the libraries were fetched from
            project.edit("build.gradle", "mavenCentral()", "maven { url = '" + mirror + "' }");
        }
        BuildResult built = project.build("build");
        assertThat(outcomes(built))
                .contains(
                        ":checkArc SUCCESS",
                        ":verifyArc SUCCESS",
                        ":testArc SUCCESS",
                        ":compileJava SUCCESS",
                        ":build SUCCESS");
        assertThat(project.path("build/nxt/Mower.jar").toFile().exists()).isEqualTo(drives);
    }

    private void create(String kind) throws IOException, InterruptedException {
        Process tool =
                new ProcessBuilder(
                                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                                "-classpath",
                                System.getProperty("tool"),
                                "arcomat.cli.Main",
                                "new",
                                "mower",
                                "--kind",
                                kind)
                        .directory(folder.toFile())
                        .inheritIO()
                        .start();
        assertThat(tool.waitFor()).isZero();
    }
}
