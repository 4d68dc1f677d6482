package arcomat.pipeline.world;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.sim.Laboratory;
import arcomat.sim.device.Limits;
import arcomat.world.Point;
import arcomat.world.Recording;
import arcomat.world.Recording.Frame;
import arcomat.world.Scene.Happening.What;
import arcomat.world.Summary;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** What is kept of a run for a campaign is what its recording says. */
class SummaryTest {
    /** What two robots can come closer between two frames, at their speeds, in mm. */
    private static final double BETWEEN_FRAMES = 100;

    @Tag("slow")
    @Test
    void theMeetingComesToWhatItsRecordingSays() throws WrongUse {
        PreparedWorld meeting = Shipped.world(Shipped.MEETING);
        for (long seed = 1; seed <= 3; seed++) {
            Summary summary = compare(meeting, seed);
            assertThat(summary.goalReached()).as("there is none").isFalse();
        }
    }

    @Tag("slow")
    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void theServiceComesToWhatItsRecordingSays(long seed) throws WrongUse {
        serve(seed);
    }

    private static void serve(long seed) throws WrongUse {
        Summary summary = compare(Shipped.world(Shipped.SERVICE), seed);
        assertThat(summary.goalReached()).isTrue();
        assertThat(summary.count(What.CUP_GIVEN)).isEqualTo(10);
    }

    /** Robots that collide, and then stand: noise of half a metre, and the first fetcher. */
    @Tag("slow")
    @Test
    void whatGoesWrongIsCounted(@TempDir Path folder) throws IOException, WrongUse {
        Path models = Path.of("models/coffee").toAbsolutePath();
        String text =
                Files.readString(models.resolve("world/meeting.world"))
                        .replace("coffee.floor.Courier", "coffee.fetcher.Fetcher")
                        .replace("$fetcher in ..", "$fetcher in " + models)
                        .replace("seconds 22", "seconds 40")
                        .replace("parameter place 4", "parameter place 40")
                        .replace("parameter turned 1.5", "parameter turned 20");
        Files.writeString(folder.resolve("rough.world"), text);
        PreparedWorld rough =
                Session.in(folder, Progress.NONE).run(new PrepareWorld("rough.world", false));
        assertThat(rough.findings()).isEmpty();
        int collisions = 0;
        int still = 0;
        for (long seed = 1; seed <= 12; seed++) {
            Summary summary = compare(rough, seed);
            collisions += summary.collisions();
            still += summary.stillSince().isPresent() ? 1 : 0;
        }
        assertThat(collisions).isPositive();
        assertThat(still).isPositive();
    }

    private static Summary compare(PreparedWorld world, long seed) {
        Recording recording = world.run(seed);
        Summary summary = world.summarize(seed, Laboratory.PATIENCE, Limits.OF_THE_BRICK);
        assertThat(summary.seed()).isEqualTo(seed);
        assertThat(summary.duration()).isEqualTo(recording.duration());
        for (What what : What.values()) {
            assertThat((long) summary.count(what)).as("%s", what).isEqualTo(recording.count(what));
        }
        assertThat(summary.delivered()).isEqualTo(recording.delivered());
        assertThat(summary.stillSince()).isEqualTo(recording.stillSince());
        assertThat(summary.failures()).isEqualTo(recording.failures());
        assertThat(summary.late()).isEqualTo(recording.late());
        double seen = apart(recording);
        assertThat(summary.apart()).isBetween(seen - BETWEEN_FRAMES, seen);
        return summary;
    }

    /** The smallest distance of the frames between two robots, one of which can drive. */
    private static double apart(Recording recording) {
        double apart = Double.POSITIVE_INFINITY;
        int size = recording.world().robots().size();
        for (Frame frame : recording.frames()) {
            for (int i = 0; i < size; i++) {
                for (int j = 0; j < i; j++) {
                    if (drives(recording, i) || drives(recording, j)) {
                        apart = Math.min(apart, apart(recording, frame, i, j));
                    }
                }
            }
        }
        return apart;
    }

    private static double apart(Recording recording, Frame frame, int i, int j) {
        Point one = frame.robots().get(i).pose().point();
        Point other = frame.robots().get(j).pose().point();
        return one.distance(other) - radius(recording, i) - radius(recording, j);
    }

    private static boolean drives(Recording recording, int robot) {
        return recording.world().robots().get(robot).kind().wheels().isPresent();
    }

    private static double radius(Recording recording, int robot) {
        return recording.world().robots().get(robot).kind().radius();
    }
}
