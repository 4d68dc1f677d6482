package arcomat.gradle;

import static arcomat.gradle.ConsumerProject.outcomes;

import static org.assertj.core.api.Assertions.assertThat;

import org.gradle.testkit.runner.BuildResult;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;

/** The case study, whose model root is the folder of its project. */
@Tag("build")
class CoffeeServiceTest {
    @TempDir private Path folder;

    @Test
    void isBuiltByThePluginAlone() {
        ConsumerProject coffee = ConsumerProject.coffee(folder);

        coffee.build("build", "checkArcFormat", "--configuration-cache");
        assertThat(coffee.path("build/nxt"))
                .isDirectoryContaining("glob:**/Dispenser.jar")
                .isDirectoryContaining("glob:**/Fetcher.jar")
                .isDirectoryContaining("glob:**/Preparer.jar");
        assertThat(coffee.read("build/reports/arcomat/checkArc.txt")).startsWith("no findings in ");
        assertThat(coffee.path("build/test-results/testArc/TEST-arc.xml")).exists();

        coffee.write("build/copies/Fetcher.arc", "no model");
        BuildResult again = coffee.build("build", "checkArcFormat", "--configuration-cache");
        assertThat(again.getOutput()).contains("Configuration cache entry reused.");
        assertThat(outcomes(again)).noneMatch(outcome -> outcome.endsWith(" SUCCESS"));
    }
}
