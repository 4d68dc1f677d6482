package arcomat.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.stream.LongStream;

/** What sensors see. */
class SensesTest {
    private static final String FLOOR = "floor 4000 4000\nnoise none\n" + Worlds.ROVER;
    private static final int ULTRASONIC = 0;
    private static final int LIGHT = 1;
    private static final int BUMPER = 2;

    private static int read(String world, int sensor) {
        return read(Worlds.of(world), 1, sensor);
    }

    private static int read(World world, long seed, int sensor) {
        Scene scene = new Physics(world, seed).start();
        Device.Sensor device = world.robots().get(0).kind().sensors().get(sensor);
        return new Senses(world, Seeds.of(seed)).read(scene, 0, device);
    }

    /** The sensor is 75 mm before the robot's middle. */
    @Test
    void ultrasonicSeesTheNearestSurface() {
        String one = FLOOR + "robot one rover at 1000 2000\n";
        assertThat(read(one, ULTRASONIC)).as("nothing there").isEqualTo(255);
        assertThat(read(one + "wall 1575 0  1575 4000\n", ULTRASONIC)).isEqualTo(50);
        assertThat(read(one + "robot two rover at 1455 2000\n", ULTRASONIC)).isEqualTo(30);
        assertThat(read(one + "robot two rover at 1455 2300\n", ULTRASONIC))
                .as("beside the cone")
                .isEqualTo(255);
        assertThat(read(one + "robot two rover at 545 2000\n", ULTRASONIC))
                .as("behind")
                .isEqualTo(255);
        assertThat(read(one + "wall 2800 0  2800 4000\n", ULTRASONIC))
                .as("too far for an echo")
                .isEqualTo(255);
    }

    @Test
    void lightSeesTheFloorBelowIt() {
        String one = FLOOR + "robot one rover at 1000 2000\n";
        assertThat(read(one, LIGHT)).isEqualTo(75);
        assertThat(read(one + "line 0 2000  4000 2000\n", LIGHT)).isEqualTo(15);
        assertThat(read(one + "line 0 2020  4000 2020\n", LIGHT)).as("its edge").isEqualTo(45);
        assertThat(read(one + "line 0 2026  4000 2026\n", LIGHT)).as("beside it").isEqualTo(75);
        assertThat(read(one + "line width 80 0 2026  4000 2026\n", LIGHT)).isEqualTo(15);
    }

    @Test
    void bumperIsReleasedInTheOpen() {
        assertThat(read(FLOOR + "robot one rover at 1000 2000\n", BUMPER)).isZero();
    }

    /** Sensors err by as much as the world says. */
    @Property(tries = 100)
    void noiseIsSmall(@ForAll @IntRange(min = 0, max = 100_000) int seed) {
        World world =
                Worlds.of(
                        FLOOR.replace("noise none", "noise light 1 distance 0 place 0 heading 0")
                                + "robot one rover at 1000 2000\nwall 1575 0  1575 4000\n");
        assertThat(read(world, seed, LIGHT)).isCloseTo(75, within(11));
        assertThat(read(world, seed, ULTRASONIC)).isEqualTo(50);
    }

    /** Noise that is the same for all seeds would be no noise. */
    @Test
    void noiseComesFromTheSeed() {
        World world =
                Worlds.of(FLOOR.replace("noise none\n", "") + "robot one rover at 1000 2000\n");
        long different =
                LongStream.range(0, 100)
                        .mapToInt(seed -> read(world, seed, LIGHT))
                        .distinct()
                        .count();
        assertThat(different).isGreaterThan(3);
    }

    /** What was drawn before stays; so do the offsets of sensors, which are drawn once. */
    @Property(tries = 100)
    void anotherSeedDrawsFromItsMomentOn(@ForAll @IntRange(min = 0, max = 1000) int seed) {
        World world =
                Worlds.of(FLOOR.replace("none", "light 4") + "robot one rover at 1000 2000\n");
        List<Integer> plain = readings(world, Seeds.of(seed));
        List<Integer> other = readings(world, Seeds.of(seed).then(100, seed + 1L));
        List<Integer> back = readings(world, Seeds.of(seed).then(100, seed + 1L).then(200, seed));
        assertThat(other.subList(0, 100)).isEqualTo(plain.subList(0, 100));
        assertThat(other.subList(100, 200)).isNotEqualTo(plain.subList(100, 200));
        assertThat(back.subList(0, 200)).isEqualTo(other.subList(0, 200));
        assertThat(back.subList(200, 300)).isEqualTo(plain.subList(200, 300));
    }

    private static List<Integer> readings(World world, Seeds seeds) {
        Scene start = new Physics(world, seeds.first()).start();
        Senses senses = new Senses(world, seeds);
        Device.Sensor light = world.robots().get(0).kind().sensors().get(LIGHT);
        return LongStream.range(0, 300)
                .mapToObj(
                        tick ->
                                new Scene(
                                        tick,
                                        start.robots(),
                                        start.drinkers(),
                                        List.of(),
                                        List.of()))
                .map(scene -> senses.read(scene, 0, light))
                .toList();
    }

    @Test
    void seedsChangeInTheOrderOfTime() {
        Seeds seeds = Seeds.of(1).then(100, 2);
        assertThatThrownBy(() -> seeds.then(100, 3)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> Seeds.of(1).then(-1, 3))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
