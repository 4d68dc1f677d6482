package arcomat.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import arcomat.world.Scene.Happening.What;
import arcomat.world.Scene.RobotState;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.constraints.Size;

import org.junit.jupiter.api.Test;

import java.util.List;

/** Laws of motion. */
class PhysicsTest {
    private static final String EMPTY = "floor 4000 4000\nnoise none\n" + Worlds.ROVER;

    /** A wheel of 56 mm rolls 176 mm in a turn. */
    @Test
    void equalWheelsGoStraightOn() {
        World world = Worlds.of(EMPTY + "robot one rover at 1000 2000 heading 90");
        RobotState robot = Worlds.drive(world, 5, new double[] {360, 360, 0}).robots().get(0);
        assertThat(robot.pose().x()).isCloseTo(1000, within(1e-6));
        assertThat(robot.pose().y()).isCloseTo(2000 + 5 * Math.PI * 56, within(12.0));
        assertThat(robot.left()).isCloseTo(Math.PI * 56, within(1e-6));
    }

    /** Twice the track for a wheel's diameter: two turns of the wheels for one of the robot. */
    @Test
    void oppositeWheelsTurnOnTheSpot() {
        World world = Worlds.of(EMPTY + "robot one rover at 1000 2000");
        RobotState robot = Worlds.drive(world, 8, new double[] {-90, 90, 0}).robots().get(0);
        assertThat(robot.pose().point().distance(new Point(1000, 2000))).isLessThan(1e-6);
        assertThat(robot.pose().heading()).isCloseTo(2 * Math.PI, within(0.1));
    }

    @Test
    void aHeavyRobotTakesLongerToStart() {
        String heavy = EMPTY.replace("body 80 900", "body 80 9000");
        double[] ahead = {360, 360, 0};
        World light = Worlds.of(EMPTY + "robot one rover at 1000 2000");
        World laden = Worlds.of(EMPTY + "robot one rover at 1000 2000 with coffee");
        World leaden = Worlds.of(heavy + "robot one rover at 1000 2000");
        double way = Worlds.drive(light, 0.2, ahead).robots().get(0).pose().x();
        assertThat(Worlds.drive(laden, 0.2, ahead).robots().get(0).pose().x()).isLessThan(way);
        assertThat(Worlds.drive(leaden, 0.2, ahead).robots().get(0).pose().x())
                .isLessThan(1000 + (way - 1000) / 2);
    }

    /** Whatever robots do, they do not drive through each other, nor through walls. */
    @Property(tries = 50)
    void bodiesNeverOverlap(
            @ForAll @Size(6) List<@DoubleRange(min = -900, max = 900) Double> speeds,
            @ForAll @LongRange(min = 0, max = 1000) long seed) {
        World world =
                Worlds.of(
                        "floor 1000 1000\nwall 500 0  500 600\n"
                                + Worlds.ROVER
                                + "robot one rover at 300 300\nrobot two rover at 700 300\n"
                                + "robot three rover at 500 800\n");
        double[][] shafts = new double[3][];
        for (int i = 0; i < shafts.length; i++) {
            shafts[i] = new double[] {speeds.get(2 * i), speeds.get(2 * i + 1), 0};
        }
        Physics physics = new Physics(world, seed);
        Scene scene = physics.start();
        for (int step = 0; step < 500; step++) {
            scene = physics.step(scene, shafts);
            for (int i = 0; i < shafts.length; i++) {
                Disc body = disc(scene, i);
                assertThat(world.contains(body.centre())).isTrue();
                assertThat(world.walls()).noneMatch(body::overlaps);
                for (int j = 0; j < i; j++) {
                    assertThat(body.overlaps(disc(scene, j))).isFalse();
                }
            }
        }
    }

    private static Disc disc(Scene scene, int robot) {
        return new Disc(scene.robots().get(robot).pose().point(), 80);
    }

    /** Pushing against a wall is one collision, however long it takes. */
    @Test
    void aCollisionIsToldOnce() {
        World world = Worlds.of(EMPTY + "wall 1200 0  1200 4000\nrobot one rover at 1000 2000");
        Physics physics = new Physics(world, 1);
        Scene scene = physics.start();
        int collisions = 0;
        for (int step = 0; step < 500; step++) {
            scene = physics.step(scene, new double[][] {{360, 360, 0}});
            collisions += scene.happenings().size();
            assertThat(scene.happenings())
                    .allMatch(happening -> happening.what() == What.COLLISION)
                    .allMatch(happening -> happening.whom().equals("a wall"));
        }
        assertThat(collisions).isEqualTo(1);
        assertThat(scene.robots().get(0).touching()).isTrue();
    }

    @Property(tries = 20)
    void aRobotMoreChangesNothingForTheOthers(@ForAll long seed) {
        String one = EMPTY.replace("noise none\n", "") + "robot one rover at 1000 2000\n";
        Scene alone = new Physics(Worlds.of(one), seed).start();
        Scene together =
                new Physics(Worlds.of(one + "robot two rover at 3000 2000\n"), seed).start();
        assertThat(together.robots().get(0)).isEqualTo(alone.robots().get(0));
    }
}
