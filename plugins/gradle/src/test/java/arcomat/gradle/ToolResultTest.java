package arcomat.gradle;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.gradle.api.GradleException;
import org.gradle.api.logging.Logger;
import org.gradle.api.logging.Logging;
import org.junit.jupiter.api.Test;

class ToolResultTest {
    private static final Logger LOG = Logging.getLogger(ToolResultTest.class);

    /** Whatever else is on the same channel, such as what {@code --verbose} tells. */
    @Test
    void theComplaintIsWhatFailsTheTask() {
        ToolResult result =
                new ToolResult(2, "", "checked 5 of 5 files\narcomat: cannot write to 'x'\n");
        assertThatThrownBy(() -> result.require(LOG))
                .isExactlyInstanceOf(GradleException.class)
                .hasMessage("cannot write to 'x'");
    }

    @Test
    void wrongUseIsToldInFull() {
        ToolResult result = new ToolResult(2, "", "Unknown option: '--x'\nUsage: arcomat check\n");
        assertThatThrownBy(() -> result.requireOutput(LOG))
                .hasMessage("Unknown option: '--x'\nUsage: arcomat check");
    }
}
