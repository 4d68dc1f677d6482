package arcomat.pipeline.campaign.joint;

import arcomat.pipeline.world.Witness.Instruments;
import arcomat.world.Scene;

import org.jspecify.annotations.Nullable;

import java.util.Map;
import java.util.Objects;

/** What there is to see at a moment, and what robots have shown since the one before. */
record WorldMoment(Map<String, ShownSlices> robots, Scene scene, Instruments instruments) {
    private static final double MILLISECONDS = 1000;

    double seconds() {
        return scene.time() / MILLISECONDS;
    }

    /** What a robot's port has shown in a slice that has ended; null where there is nothing. */
    @Nullable Object shown(String robot, int slice, int tap) {
        return Objects.requireNonNull(robots.get(robot)).message(slice, tap);
    }
}
