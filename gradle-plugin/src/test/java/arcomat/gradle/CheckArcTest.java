package arcomat.gradle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.gradle.testkit.runner.TaskOutcome.SUCCESS;
import static org.gradle.testkit.runner.TaskOutcome.UP_TO_DATE;

import org.gradle.testkit.runner.BuildResult;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;

class CheckArcTest {
    @TempDir private Path folder;

    @Test
    void checksWhatHasChangedAndNothingElse() {
        ConsumerProject project = ConsumerProject.in(folder);

        BuildResult first = project.build("checkArc");
        assertThat(first.task(":checkArc").getOutcome()).isEqualTo(SUCCESS);
        assertThat(project.read("build/reports/arcomat/checkArc.txt"))
                .isEqualTo("no findings in 3 files\n");
        assertThat(project.build("checkArc").task(":checkArc").getOutcome()).isEqualTo(UP_TO_DATE);

        project.edit(ConsumerProject.BUMPER, "wheels = halt", "wheels = hald");
        BuildResult failed = project.fail("check");
        assertThat(failed.getOutput())
                .contains(
                        "src/main/arc/shop/Bumper.arc:14:56: error ARC0329: 'hald' is not",
                        "did you mean 'halt'?",
                        "> 1 error in 3 files")
                .doesNotContain("Exception");
    }
}
