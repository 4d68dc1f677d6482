package arcomat.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import arcomat.world.Recording.Late;

import org.junit.jupiter.api.Test;

import java.util.Map;

/** How close robots come to what, and what else is kept of a run. */
class TallyTest {
    private static final String QUIET = "noise none\n";

    private static Summary drive(String text, double seconds, double[]... shafts) {
        World world = Worlds.of(text);
        Physics physics = new Physics(world, 1);
        Tally tally = new Tally(world, 1);
        Scene scene = physics.start();
        tally.see(scene);
        for (int step = 0; step < seconds * 1000 / Physics.STEP; step++) {
            scene = physics.step(scene, shafts);
            tally.see(scene);
        }
        return tally.summary();
    }

    @Test
    void theSmallestDistanceBetweenRobotsIsThatOfTheirBodies() {
        Summary summary =
                drive(
                        "floor 3000 1000\n"
                                + QUIET
                                + Worlds.ROVER
                                + "robot one rover at 500 500\nrobot two rover at 1500 300\n",
                        20,
                        new double[] {180, 180, 0},
                        new double[3]);
        assertThat(summary.apart()).as("passes below").isCloseTo(40, within(0.01));
        assertThat(summary.collisions()).isZero();
        assertThat(summary.duration()).isEqualTo(20_000);
        assertThat(summary.stillSince()).isEmpty();
    }

    @Test
    void wallsAreMetByTheBodyAndTheEdgeByTheMiddle() {
        String start = "floor 3000 1000\n" + QUIET + Worlds.ROVER;
        Summary wall =
                drive(
                        start + "wall 2000 100 2000 900\nrobot one rover at 1000 500\n",
                        0.1,
                        new double[3]);
        assertThat(wall.clear()).isEqualTo(500);
        Summary edge = drive(start + "robot one rover at 1000 300\n", 0.1, new double[3]);
        assertThat(edge.clear()).isEqualTo(300);
        assertThat(edge.apart()).as("of one robot").isInfinite();
        Summary ahead =
                drive(
                        start + "wall 1300 100 1300 900\nrobot one rover at 1000 500\n",
                        0.1,
                        new double[3]);
        assertThat(ahead.clear()).isEqualTo(220);
    }

    @Test
    void thingsAreMetByTheBody() {
        String start =
                "floor 3000 1000\n"
                        + QUIET
                        + Worlds.ROVER
                        + "robot one rover at 700 500\nthing box at 1000 500 body 60 300\n";
        assertThat(drive(start, 0.1, new double[3]).clear()).isEqualTo(160);
        Summary pushing = drive(start, 5, new double[] {360, 360, 0});
        assertThat(pushing.clear()).isCloseTo(0, within(0.01));
        assertThat(pushing.collisions()).isZero();
    }

    @Test
    void aRobotThatPushesStandsStill() {
        Summary summary =
                drive(
                        "floor 3000 1000\n"
                                + QUIET
                                + "wall 1000 0 1000 1000\n"
                                + Worlds.ROVER
                                + "robot one rover at 500 500\n",
                        30,
                        new double[] {360, 360, 0});
        assertThat(summary.collisions()).isEqualTo(1);
        assertThat(summary.clear()).isBetween(0.0, 2.0);
        assertThat(summary.stillSince()).isPresent();
    }

    @Test
    void lateSlicesAreAddedUp() {
        Tally tally =
                new Tally(
                        Worlds.of(
                                "floor 3000 1000\n" + Worlds.ROVER + "robot a rover at 500 500\n"),
                        7);
        tally.late("b", 3000);
        tally.late("a", 1000);
        tally.late("b", 2000);
        tally.failed("a", "stuck");
        tally.sent(42);
        Summary summary = tally.summary();
        assertThat(summary.late()).containsExactly(new Late("a", 1, 1000), new Late("b", 2, 3000));
        assertThat(summary.lateSlices()).isEqualTo(3);
        assertThat(summary.failures()).isEqualTo(Map.of("a", "stuck"));
        assertThat(summary.duration()).isEqualTo(42);
        assertThat(summary.seed()).isEqualTo(7);
    }
}
