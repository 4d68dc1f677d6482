package arcomat.gradle;

import static arcomat.gradle.ConsumerProject.outcomes;

import static org.assertj.core.api.Assertions.assertThat;

import org.gradle.testkit.runner.BuildResult;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;

/** A small project's life: built, built again, elsewhere, changed, broken. */
@Tag("build")
class ShopTest {
    private static final String BUMPER = "src/main/arc/shop/Bumper.arc";

    @TempDir private Path folder;
    private ConsumerProject shop;

    @BeforeEach
    void setUp() {
        shop = shop("shop");
    }

    private ConsumerProject shop(String name) {
        ConsumerProject project = ConsumerProject.shop(folder.resolve(name));
        project.append("settings.gradle", "buildCache.local.directory = '../cache'\n");
        return project;
    }

    @Test
    void isBuiltOnceAndNeverAgain() {
        shop.write("templates/target.properties", "base = jvm\n");
        shop.append(
                "build.gradle",
                """
                tasks.register('generateArcMine', arcomat.gradle.GenerateArc) {
                    templates = file('templates')
                }
                """);
        String[] all = {"build", "checkArcFormat", "generateArcMine", "--configuration-cache"};
        BuildResult first = shop.build(all);
        assertThat(outcomes(first))
                .contains(
                        ":checkArc SUCCESS",
                        ":checkArcFormat SUCCESS",
                        ":verifyArc SUCCESS",
                        ":testArc SUCCESS",
                        ":generateArcJvm SUCCESS",
                        ":compileJava SUCCESS",
                        ":generateArcLejos SUCCESS",
                        ":nxtJar SUCCESS",
                        ":brickCheck SUCCESS",
                        ":generateArcMine SUCCESS");
        assertThat(shop.path("build/nxt/Rover.jar")).exists();
        assertThat(shop.path("build/classes/java/main/shop/logic/Bumper.class")).exists();
        assertThat(shop.read("build/test-results/testArc/TEST-arc.xml"))
                .contains("tests=\"1\" failures=\"0\"", "name=\"stops\"");
        assertThat(shop.read("build/reports/arcomat/checkArc.txt"))
                .isEqualTo("no findings in 5 files\n");

        BuildResult second = shop.build(all);
        assertThat(second.getOutput()).contains("Configuration cache entry reused.");
        assertThat(outcomes(second)).noneMatch(outcome -> outcome.endsWith(" SUCCESS"));
    }

    @Test
    void isTakenFromTheCacheInAnotherFolder() {
        shop.build("check", "assemble", "checkArcFormat", "--build-cache");

        ConsumerProject elsewhere = shop("elsewhere");
        BuildResult again = elsewhere.build("check", "assemble", "checkArcFormat", "--build-cache");
        assertThat(outcomes(again))
                .contains(
                        ":checkArc FROM_CACHE",
                        ":checkArcFormat FROM_CACHE",
                        ":verifyArc FROM_CACHE",
                        ":testArc FROM_CACHE",
                        ":generateArcJvm FROM_CACHE",
                        ":generateArcLejos FROM_CACHE",
                        ":brickCheck FROM_CACHE");
        assertThat(elsewhere.path("build/nxt/Rover.jar")).exists();
    }

    @Test
    void saysWhatIsWrongAndWhere() {
        shop.append("build.gradle", "arcomat.warningsFail = project.hasProperty('strict')\n");
        shop.append(
                "build.gradle",
                "if (project.hasProperty('known')) arcomat.baseline = file('known.txt')\n");
        shop.edit(BUMPER, "port in Boolean", "port <<totl>> in  Boolean");

        BuildResult warned = shop.build("checkArc");
        assertThat(warned.getOutput())
                .contains(
                        "src/main/arc/shop/Bumper.arc:7:12: warning ARC0501: stereotype 'totl'",
                        "1 warning in 5 files");
        assertThat(shop.fail("checkArc", "-Pknown").getOutput())
                .contains("> there is no baseline 'known.txt'; the task baselineArc writes it");
        BuildResult strict = shop.fail("checkArc", "checkArcFormat", "-Pstrict", "--continue");
        assertThat(strict.getOutput())
                .contains(
                        "Execution failed for task ':checkArc'.\n> 1 warning in 5 files",
                        "would change src/main/arc/shop/Bumper.arc",
                        "Execution failed for task ':checkArcFormat'.\n"
                                + "> 1 of 5 files would change");

        assertThat(shop.read("build/reports/arcomat/checkArc.sarif")).contains("\"ARC0501\"");
        shop.build("baselineArc", "-Pknown");
        assertThat(shop.read("known.txt")).contains("ARC0501");
        assertThat(outcomes(shop.build("checkArc", "-Pstrict", "-Pknown")))
                .contains(":checkArc SUCCESS");

        shop.edit(BUMPER, "wheels = halt", "wheels = hald");
        BuildResult failed = shop.fail("check", "--info");
        assertThat(failed.getOutput())
                .contains(
                        "src/main/arc/shop/Bumper.arc:14:56: error ARC0329: 'hald' is not",
                        "help: Change to 'halt'",
                        "> 1 error, 1 warning in 5 files",
                        "checked 3 of 5 files")
                .doesNotContain("Exception");
    }

    @Test
    void showsHowModelsBehave() {
        ConsumerProject.copy(shop.path("src/main/arc"), shop.path("base"));
        shop.edit(BUMPER, "wheels = halt", "wheels = go");
        shop.write("src/test/arc/shop/Ramp.arc", RAMP);

        BuildResult failed =
                shop.fail("testArc", "verifyArc", "gateArc", "--base=base", "--continue");
        assertThat(failed.getOutput())
                .contains(
                        "Execution failed for task ':testArc'.\n> 0 passed, 1 failed",
                        "FAILED stops (line 4)",
                        "fails: shop.Ramp does not refine shop.Bumper",
                        "Execution failed for task ':verifyArc'.\n> 0 hold, 1 fail, 0 unknown",
                        "shop.Bumper",
                        "Execution failed for task ':gateArc'.")
                .doesNotContain("Exception");
        assertThat(shop.read("build/test-results/testArc/TEST-arc.xml"))
                .contains("tests=\"1\" failures=\"1\"");
        assertThat(shop.read("build/test-results/gateArc/TEST-arc.xml")).contains("failures=\"2\"");
        assertThat(
                        shop.fail("gateArc", "--base=base", "--campaign=no.campaign", "--no-limits")
                                .getOutput())
                .contains("there is no campaign 'no.campaign'")
                .doesNotContain("Exception");

        shop.edit(BUMPER, "    port", "port");
        BuildResult shown =
                shop.build("formatArc", "simulateArc", "--main=shop.Bumper", "--slices=3");
        assertThat(shown.getOutput())
                .contains("changed src/main/arc/shop/Bumper.arc", "slice  input", "wheels = go");
        assertThat(shop.read(BUMPER)).contains("    port");
    }

    private static final String RAMP =
            """
            package shop;

            import shop.Shop.*;

            /** Stops everywhere. */
            component Ramp refines Bumper {
                port in Boolean wall, out Command wheels;

                automaton {
                    state driving;

                    initial driving / {wheels = go};

                    driving -> driving {wall == ?} / {wheels = halt};
                }
            }
            """;
}
