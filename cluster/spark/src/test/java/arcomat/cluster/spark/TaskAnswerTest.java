package arcomat.cluster.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.campaign.Row;
import arcomat.campaign.coverage.ReachedItems;
import arcomat.pipeline.campaign.engine.Answer;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;

class TaskAnswerTest {
    private static final TaskAnswer MADE =
            TaskAnswer.made(
                    List.of(
                            new Answer(
                                    7,
                                    Row.Ending.MADE,
                                    "",
                                    List.of(0.1, Double.NaN, -0.0),
                                    new ReachedItems("x0c")),
                            new Answer(
                                    1L << 40,
                                    Row.Ending.IMPOSSIBLE,
                                    "Straße",
                                    List.of(),
                                    ReachedItems.UNKNOWN)),
                    12);

    @Test
    void whatIsWrittenIsRead() throws IOException {
        assertThat(TaskAnswer.of(MADE.bytes())).isEqualTo(MADE);
    }

    @Test
    void aFaultTravelsAsText() throws IOException {
        TaskAnswer failed = TaskAnswer.failed(new StackOverflowError());
        assertThat(TaskAnswer.of(failed.bytes()).why())
                .isEqualTo(
                        "a run could not be made, this is a fault of arcomat:"
                                + " java.lang.StackOverflowError");
    }

    @Test
    void halfAnAnswerIsNone() {
        byte[] whole = MADE.bytes();
        for (int i = 0; i < whole.length; i++) {
            byte[] cut = Arrays.copyOf(whole, i);
            assertThatThrownBy(() -> TaskAnswer.of(cut)).isInstanceOf(IOException.class);
        }
    }
}
