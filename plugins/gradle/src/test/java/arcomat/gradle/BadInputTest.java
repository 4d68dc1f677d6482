package arcomat.gradle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;

/** Whatever a build script may have wrong is told in one sentence, and never as a stack trace. */
@Tag("build")
class BadInputTest {
    @TempDir private Path folder;
    private ConsumerProject shop;

    @BeforeEach
    void setUp() {
        shop = ConsumerProject.shop(folder);
    }

    /** One build of many projects, each with a fault of its own. */
    @Test
    void isToldInOneSentence() {
        String script = shop.read("build.gradle");
        variant("component", script.replace("shop.Rover", "shop.Rovr"));
        variant("roots", script + "sourceSets.main.arc.srcDir '../src/main/arc'\n");
        variant("linker", script + "arcomat.nxjHome = file('nowhere')\n");
        variant("choice", script + "arcomat.choose = 'some'\n");
        variant("binary", script);
        shop.write("binary/src/main/arc/shop/Spoilt.arc", "\0");
        variant("known", script + "arcomat.baseline = file('known.txt')\n");
        variant("version", script.replace("arcomat files", "//") + VERSION);

        String output =
                shop.fail(
                                ":component:generateArcJvm",
                                ":roots:checkArc",
                                ":linker:nxjLink",
                                ":choice:generateArcJvm",
                                ":binary:checkArc",
                                ":known:checkArc",
                                ":version:checkArc",
                                "--continue")
                        .getOutput();
        assertThat(output)
                .contains(
                        "> there is no component 'shop.Rovr'; did you mean 'shop.Rover'?",
                        "error ARC0214: 'shop.Bumper' is defined twice; rename one",
                        "linker/nowhere' is not a folder of leJOS NXJ: it has no program"
                                + " bin/nxjlink",
                        "> Invalid value for option '--choose'",
                        "Execution failed for task ':binary:checkArc'.\n> 1 error in 6 files",
                        "> there is no baseline 'known/known.txt'; the task baselineArc writes it",
                        "> Could not find arcomat:arcomat:9.9.9.")
                .doesNotContain("Exception", "ARC0701");
    }

    private static final String VERSION =
            """
            arcomat.toolVersion = '9.9.9'
            repositories {
                maven { url = 'repository' }
            }
            """;

    @Test
    void aTargetThatIsNone() {
        shop.edit("build.gradle", "'lejos'", "'lejoz'");
        assertThat(shop.fail("check").getOutput())
                .contains("> arcomat.targets names 'lejoz', and there are jvm and lejos; for")
                .doesNotContain("Exception", "ARC0701");
    }

    private void variant(String name, String script) {
        shop.append("settings.gradle", "include '" + name + "'\n");
        shop.write(name + "/build.gradle", script);
        ConsumerProject.copy(shop.path("src"), shop.path(name + "/src"));
    }
}
