package arcomat.gradle;

import static arcomat.gradle.ConsumerProject.outcomes;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.nio.file.Path;

/** The guests of {@code guests/} know nothing of this build but a repository. */
@Tag("build")
class GuestBuildsTest {
    @TempDir private Path folder;

    @ParameterizedTest
    @CsvSource({
        "blink, tryLanguage, src/main/java/blink/Blink.java, equals(\"on\"), equals(\"off\")",
        "lab, tryLaws, src/main/java/lab/PortSaysWhatIs.java, says what is not, says nothing",
        "montiarc7, tryModels, src/main/java/montiarc7/StartWriter.java, !delayed.contains,"
                + " delayed.contains",
        "statemachine, tryLanguage, src/main/java/statemachine/Entering.java, DEEP ?, SHALLOW ?"
    })
    void isBuiltAndTried(String guest, String task, String file, String good, String bad) {
        ConsumerProject project = ConsumerProject.published(Path.of("../../guests", guest), folder);
        String version = "-ParcomatVersion=" + System.getProperty("version");
        assertThat(outcomes(project.build("check", version))).contains(":" + task + " SUCCESS");

        project.edit(file, good, bad);
        assertThat(outcomes(project.fail("check", version))).contains(":" + task + " FAILED");
    }

    @Test
    void areDependenciesOfProjectsWithModels() {
        ConsumerProject lab =
                ConsumerProject.published(Path.of("../../guests/lab"), folder.resolve("lab"));
        lab.build("jar", "-ParcomatVersion=" + System.getProperty("version"));
        ConsumerProject shop = ConsumerProject.publishedShop(folder.resolve("shop"));
        shop.append(
                "build.gradle",
                "dependencies { arcomatGuests files('../lab/build/libs/lab-laws.jar') }\n");
        shop.write(
                "src/main/arc/shop/Odd.arc",
                "package shop;\n\ncomponent Odd {\n    port in Boolean notSaid;\n}\n");
        assertThat(shop.build("checkArc").getOutput())
                .contains("warning LAB0001: port 'notSaid' says what is not");
    }
}
