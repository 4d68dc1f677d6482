package arcomat.gradle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;

/** The engine that makes runs of campaigns on other machines. */
@Tag("build")
class ClusterTest {
    private static final String[] GATE = {
        "gateArc",
        "--base=src/main/arc",
        "--campaign=some.campaign",
        "--cluster=laboratory",
        "--at=0.0.0.0" // which it does not open without a secret
    };

    @TempDir private Path folder;

    @Test
    void isADependencyOfTheTool() {
        ConsumerProject shop = ConsumerProject.shop(folder);
        assertThat(shop.fail(GATE).getOutput()).contains("there is no engine for clusters");
        shop.useEngineOfThisBuild();
        assertThat(shop.fail(GATE).getOutput())
                .contains("> --at 0.0.0.0 can be reached from other machines");
    }
}
