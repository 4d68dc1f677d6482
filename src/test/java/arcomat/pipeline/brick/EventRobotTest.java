package arcomat.pipeline.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.need.Needs;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.generate.GenerateCode;

import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** What is predicted for robots that are driven by events. */
class EventRobotTest {
    @TempDir private Path folder;

    private Needs needs(String robot) throws Exception {
        String out = folder.toString();
        List<String> models = List.of("src/test/resources/truth");
        GenerateCode task =
                new GenerateCode("lejos", out, Optional.of(robot), false, List.of(), models);
        GenerateCode.Made made =
                Session.in(Path.of(""), Progress.NONE).run(task).value().orElseThrow();
        return made.robots().get(0).report().needs();
    }

    /**
     * All events that fit into the queues, and what follows from them: the counter handles 16 in 17
     * rounds, the adder behind it in the chain up to three for each of them and 16 of its own, but
     * not more than one in each of 32 rounds.
     */
    @ParameterizedTest
    @CsvSource({"Counter, 3500, 5000", "Chain, 13000, 18000", "Crossing, 4000, 6000"})
    void queuesThatAreFullAreWorkedOff(String robot, long least, long most) throws Exception {
        Needs.Need slice = needs("events." + robot).slice();

        assertThat(slice.isBound()).isTrue();
        assertThat(slice.amount().orElseThrow()).isBetween(least, most);
        assertThat(slice.isAbove(0)).isFalse();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '#',
            value = "events.Circle # parts may send each other events without end")
    void whatGoesRoundHasNoEnd(String robot, String why) throws Exception {
        assertThat(needs(robot).slice().unknown()).hasValue(why);
        assertThat(needs(robot).memory().amount()).isPresent();
    }
}
