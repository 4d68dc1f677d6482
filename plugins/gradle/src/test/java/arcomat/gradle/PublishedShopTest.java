package arcomat.gradle;

import static arcomat.gradle.ConsumerProject.outcomes;

import static org.assertj.core.api.Assertions.assertThat;

import org.gradle.testkit.runner.BuildResult;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;

/** A small project that knows nothing of this build but a repository. */
@Tag("build")
class PublishedShopTest {
    @TempDir private Path folder;
    private ConsumerProject shop;

    @BeforeEach
    void setUp() {
        shop = ConsumerProject.publishedShop(folder);
    }

    @Test
    void isBuiltAndRuns() {
        shop.append("build.gradle", RUN);
        shop.write("src/main/java/shop/Drive.java", DRIVE);

        BuildResult built = shop.build("build", "drive");
        assertThat(outcomes(built))
                .contains(
                        ":checkArc SUCCESS",
                        ":verifyArc SUCCESS",
                        ":testArc SUCCESS",
                        ":generateArcJvm SUCCESS",
                        ":nxtJar SUCCESS",
                        ":brickCheck SUCCESS",
                        ":drive SUCCESS");
        assertThat(built.getOutput()).contains("halts: true");
        assertThat(shop.path("build/nxt/Rover.jar")).exists();
    }

    private static final String RUN =
            """
            tasks.register('drive', JavaExec) {
                classpath = sourceSets.main.runtimeClasspath
                mainClass = 'shop.Drive'
            }
            """;

    private static final String DRIVE =
            """
            package shop;

            import arcomat.rt.Cycle;

            import shop.logic.Bumper;

            /** Meets a wall in the second slice. */
            public final class Drive {
                public static void main(String[] arguments) {
                    Bumper bumper = new Bumper();
                    Cycle cycle = new Cycle(10);
                    cycle.await();
                    bumper.hasWall = true;
                    bumper.wall = true;
                    bumper.step();
                    System.out.println("halts: " + (bumper.wheels == CommandCode.HALT));
                }
            }
            """;

    @Test
    void asksForAVersionThatIsNowhere() {
        shop.append("build.gradle", "arcomat.toolVersion = '9.9.9'\n");
        assertThat(shop.fail("checkArc").getOutput())
                .containsPattern("> Could not (find|resolve) arcomat:arcomat:9\\.9\\.9\\.")
                .doesNotContain("Exception");
    }
}
