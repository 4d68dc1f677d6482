package arcomat.gradle;

import static arcomat.gradle.ConsumerProject.outcomes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The oldest Gradle that the plugin is for, where {@code gradle/central/assemble} has put it. What
 * newer ones have fetched it does not find, so it takes nothing from repositories.
 */
@Tag("build")
class OldestGradleTest {
    private static final Path HOME =
            Path.of(System.getProperty("gradle.user.home"), "central-dists/gradle-7.6");

    @TempDir private Path folder;
    private ConsumerProject shop;

    @BeforeEach
    void setUp() {
        assumeTrue(Files.exists(HOME.resolve("bin/gradle")), "Gradle 7.6 has not been assembled");
        shop = ConsumerProject.shop(folder).by(HOME);
    }

    @Test
    void buildsAllAndNothingTwice() {
        assertThat(outcomes(shop.build("build")))
                .contains(
                        ":checkArc SUCCESS",
                        ":verifyArc SUCCESS",
                        ":testArc SUCCESS",
                        ":generateArcJvm SUCCESS",
                        ":nxtJar SUCCESS",
                        ":brickCheck SUCCESS");
        assertThat(shop.path("build/nxt/Rover.jar")).exists();
        assertThat(outcomes(shop.build("build")))
                .contains(
                        ":checkArc UP_TO_DATE",
                        ":verifyArc UP_TO_DATE",
                        ":generateArcJvm UP_TO_DATE",
                        ":nxtJar UP_TO_DATE");
    }

    @Test
    void tellsWhatIsWrongWithAModel() {
        shop.edit("src/main/arc/shop/Bumper.arc", "component Bumper", "component Bumpr");
        assertThat(shop.fail("checkArc").getOutput()).contains("Bumper.arc:", "error ARC");
    }

    @Test
    void givesModelsToAnotherProject(@TempDir Path two) {
        String robot = "dependencies { arcomatModels project(':parts') }";
        ConsumerProject projects = ConsumerProject.shopOfTwo(two, "", robot).by(HOME);
        projects.write(
                "robot/src/main/java/shop/Lap.java", projects.read("src/main/java/shop/Lap.java"));
        assertThat(outcomes(projects.build("assemble")))
                .contains(
                        ":parts:modelsJar SUCCESS",
                        ":robot:unpackArcModels SUCCESS",
                        ":robot:compileJava SUCCESS",
                        ":robot:nxtJar SUCCESS");
    }
}
