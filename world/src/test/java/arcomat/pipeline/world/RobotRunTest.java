package arcomat.pipeline.world;

import static arcomat.report.ShownTracks.texts;
import static arcomat.report.ShownTracks.track;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Trace;
import arcomat.report.page.Story;
import arcomat.report.run.RunDrawings;
import arcomat.report.run.TracePage;
import arcomat.report.world.PacketWords;
import arcomat.sim.Laboratory;
import arcomat.sim.device.Limits;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.RobotRun;
import arcomat.simulate.run.Simulation;
import arcomat.world.Seeds;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** What goes on inside of robots, as the page of a world tells it, is what their models do. */
class RobotRunTest {
    /** Its wheels are told by events what its bumper and its eye say by events. */
    private static final String BUMPS = "world/src/test/resources/world/bumps/bumps.world";

    private static List<RobotRun> inside(String world) throws Exception {
        return inside(Shipped.world(world));
    }

    private static List<RobotRun> inside(PreparedWorld world) {
        return world.explain(Seeds.of(1), Laboratory.PATIENCE, Limits.OF_THE_BRICK).inside();
    }

    @Tag("slow")
    @Test
    void theInterpreterDoesTheSameInTheMeeting() throws Exception {
        List<RobotRun> inside = inside(Shipped.MEETING);
        assertThat(inside).extracting(RobotRun::robot).containsExactly("empty", "loaded");
        inside.forEach(RobotRunTest::isWhatItsModelDoes);
    }

    @Tag("slow")
    @Test
    void theInterpreterDoesTheSameInTheService() throws Exception {
        List<RobotRun> inside = inside(Shipped.SERVICE);
        assertThat(inside)
                .extracting(RobotRun::robot)
                .containsExactlyInAnyOrder("courier", "dispenser", "preparer");
        inside.forEach(RobotRunTest::isWhatItsModelDoes);
        packetsAreToldByTheirConstants(PacketWords.of(inside));
    }

    @Tag("slow")
    @Test
    void theInterpreterDoesTheSameWhereEventsDriveARobot() throws Exception {
        RobotRun rover = inside(Shipped.at(BUMPS)).get(0);
        isWhatItsModelDoes(rover);
        Story story = TracePage.story("", rover.trace(), rover.times(), new RunDrawings());
        assertThat(story.timeline().unit()).isEqualTo("cycle");
        assertThat(changes(story, "mind"))
                .containsExactly("driving", "backing", "driving", "standing");
        assertThat(changes(story, "mind.speed"))
                .containsExactly("360", "-", "-360", "-", "360", "-", "-360, 0", "-");
        assertThat(changes(story, "counter.bumps")).containsExactly("-", "1", "2", "3");
        assertThat(texts(track(story, "mind because")))
                .as("both transitions of one cycle")
                .anyMatch(each -> each.matches(".*speed = -360.*; then .*speed = 0.*"));
        assertThat(story.drawings())
                .extracting(Story.Drawing::title)
                .containsExactlyInAnyOrder("p.Rover", "counter", "mind");
    }

    private static List<String> changes(Story story, String name) {
        List<String> changes = new ArrayList<>();
        for (String each : texts(track(story, name))) {
            if (changes.isEmpty() || !changes.get(changes.size() - 1).equals(each)) {
                changes.add(each);
            }
        }
        return changes;
    }

    private static void isWhatItsModelDoes(RobotRun run) {
        Trace told = run.trace();
        assertThat(told.steps()).hasSizeGreaterThan(100);
        assertThat(run.times()).hasSameSizeAs(told.steps()).isSorted();
        Interpreter interpreter =
                new Interpreter(told.component(), List.of(), Choice.first()).explaining();
        Trace interpreted = Simulation.run(interpreter, told.received());
        for (int step = 0; step < told.steps().size(); step++) {
            assertThat(interpreted.steps().get(step))
                    .as("%s, slice %d", run.robot(), step)
                    .isEqualTo(told.steps().get(step));
        }
    }

    private static void packetsAreToldByTheirConstants(PacketWords words) {
        assertThat(words.of("preparer", "0000000001")).contains("hold");
        assertThat(words.of("preparer", "0000000002")).contains("go");
        assertThat(words.of("preparer", "0000000003")).isEmpty();
        assertThat(words.of("preparer", "0100000001")).as("another channel").isEmpty();
        assertThat(words.of("courier", "0000000001")).as("who sends nothing").isEmpty();
        assertThat(words.of("preparer", "00")).isEmpty();
    }
}
