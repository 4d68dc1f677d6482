package arcomat.report.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** Another run on the floor of a page is read from what a page has written. */
class GhostTest {
    @Test
    void aRecordingIsRead() {
        String text =
                """
                {"seed": 7, "period": 100, "world": {"robots": [{"name": "one"}]},
                 "frames": [{"t": 0, "robots": [[1.5, 2, 90, 0, 0]]}]}
                """;
        assertThat(Ghost.read(text, "a.json"))
                .contains(
                        new Ghost(
                                "a.json, seed 7",
                                100,
                                List.of("one"),
                                List.of(List.of(List.of(1.5, 2.0, 90.0)))));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "# A page",
                "[]",
                "{}",
                "{\"period\": 100, \"world\": {\"robots\": [{\"name\": \"one\"}]}, \"frames\": []}",
                "{\"period\": 100, \"world\": {\"robots\": [{\"name\": \"one\"}]}, \"frames\":"
                        + " [{\"robots\": []}]}",
                "{\"period\": 100, \"world\": {\"robots\": [{\"name\": \"one\"}]}, \"frames\":"
                        + " [{\"robots\": [[1, 2]]}]}"
            })
    void whatIsNoRecordingIsNone(String text) {
        assertThat(Ghost.read(text, "a.json")).isEmpty();
    }
}
