package arcomat.gradle;

import static arcomat.gradle.ConsumerProject.outcomes;

import static org.assertj.core.api.Assertions.assertThat;

import org.gradle.testkit.runner.BuildResult;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;

/** A build of two projects: the models of one are made of those of the other. Neither has tests. */
@Tag("build")
class ModulesTest {
    private static final String ROVER = "src/main/arc/shop/Rover.arc";

    @TempDir private Path folder;
    private ConsumerProject shop;

    @BeforeEach
    void setUp() {
        shop =
                ConsumerProject.shopOfTwo(
                        folder,
                        "",
                        """
                        sourceSets.main.arc.srcDir project(':parts').file('src/main/arc')
                        println "Java is ${tasks.compileJava.options.encoding}"
                        """);
    }

    @Test
    void modelsOfAnotherProject() {
        BuildResult built = shop.build("build", "--parallel");
        assertThat(outcomes(built))
                .contains(
                        ":parts:testArc NO_SOURCE",
                        ":parts:verifyArc SUCCESS",
                        ":robot:testArc NO_SOURCE",
                        ":robot:nxtJar SUCCESS",
                        ":robot:build SUCCESS");
        assertThat(shop.path("robot/build/nxt/Rover.jar")).exists();
        assertThat(shop.read("robot/build/reports/arcomat/checkArc.txt"))
                .isEqualTo("no findings in 4 files\n");
        assertThat(built.getOutput()).contains("Java is UTF-8");
    }

    /** With {@code --continue} a task may begin although one has failed that it goes by. */
    @Test
    void nothingIsMadeOfBrokenModels() {
        shop.edit("robot/" + ROVER, "motor.speed", "motor.sped");
        BuildResult failed = shop.fail(":robot:build", "--continue");
        assertThat(outcomes(failed))
                .contains(
                        ":robot:checkArc FAILED",
                        ":robot:generateArcJvm FAILED",
                        ":robot:generateArcLejos FAILED")
                .noneMatch(outcome -> outcome.matches(":robot:(compileJava|jar|nxtJar) .*"));
        assertThat(failed.getOutput())
                .contains("robot/" + ROVER + ":17:33: error ARC0103")
                .doesNotContain("Exception");
    }
}
