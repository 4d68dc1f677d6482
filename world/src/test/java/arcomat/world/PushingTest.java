package arcomat.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.Scene.RobotState;
import arcomat.world.Scene.ThingState;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.constraints.Size;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.aggregator.ArgumentsAccessor;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Things that are pushed. */
class PushingTest {
    private static final Path WORLDS = Path.of("world/src/test/resources/world/push");

    /** How near in mm things have to be to where they are expected. */
    private static final double NEAR = 2;

    /** How far apart in mm bodies may be that have pushed each other in the last step. */
    private static final double PASSING = 0.5;

    /** In mm per second, in each second. */
    private static final double GRAVITY = 9810;

    /** Motors of three robots. */
    private static final double[][] STILL = new double[3][3];

    /** Walls, robots and things of all weights in a small place. */
    private static final String CROWD =
            """
            floor 1000 1000
            wall 500 0  500 500
            wall 200 800  600 900
            robot one rover at 300 300 heading 20
            robot two rover at 700 300 heading 170
            robot three rover at 800 800 heading -100
            thing light at 400 600 body 50 100
            thing heavy at 600 650 body 90 5000
            thing box at 150 500 body 60 600
            thing ball at 750 550 body 40 300 friction 0
            """
                    + Worlds.ROVER;

    static Stream<Path> worlds() throws IOException {
        try (Stream<Path> files = Files.list(WORLDS)) {
            return files
                    .filter(file -> file.toString().endsWith(".world"))
                    .sorted()
                    .toList()
                    .stream();
        }
    }

    /**
     * Each world says how its robots drive, and where something is then: {@code # drive LEFT RIGHT}
     * for each robot, {@code # after SECONDS NAME X Y}.
     */
    @ParameterizedTest
    @MethodSource("worlds")
    void bodiesComeToWhereTheyAreExpected(Path file) throws IOException {
        String text = Files.readString(file);
        World world = Worlds.of(text + "noise none\n" + Worlds.ROVER);
        double[][] shafts =
                lines(text, "# drive ")
                        .map(words -> new double[] {number(words[0]), number(words[1]), 0})
                        .toArray(double[][]::new);
        assertThat(lines(text, "# after ")).isNotEmpty();
        lines(text, "# after ")
                .forEach(
                        words -> {
                            Scene scene = Worlds.drive(world, number(words[0]), shafts);
                            Point found = place(world, scene, words[1]);
                            Point expected = new Point(number(words[2]), number(words[3]));
                            assertThat(found.distance(expected))
                                    .as("%s is at %s", String.join(" ", words), found)
                                    .isLessThan(NEAR);
                        });
    }

    private static Stream<String[]> lines(String text, String beginning) {
        return text.lines()
                .filter(line -> line.startsWith(beginning))
                .map(line -> line.substring(beginning.length()).split(" "));
    }

    private static double number(String word) {
        return Double.parseDouble(word);
    }

    private static Point place(World world, Scene scene, String name) {
        Stream<Point> robots =
                IntStream.range(0, world.robots().size())
                        .filter(i -> world.robots().get(i).name().equals(name))
                        .mapToObj(i -> scene.robots().get(i).pose().point());
        Stream<Point> things =
                IntStream.range(0, world.things().size())
                        .filter(i -> world.things().get(i).name().equals(name))
                        .mapToObj(i -> scene.things().get(i).place());
        return Stream.concat(robots, things).findFirst().orElseThrow();
    }

    /** Whatever robots do: nothing is where something else is. */
    @Tag("slow")
    @Property(tries = 100)
    void bodiesNeverOverlap(
            @ForAll @Size(6) List<@DoubleRange(min = -900, max = 900) Double> speeds,
            @ForAll @LongRange(min = 0, max = 1000) long seed) {
        World world = Worlds.of(CROWD);
        Physics physics = new Physics(world, seed);
        Scene scene = physics.start();
        double[][] shafts = shafts(speeds);
        for (int step = 0; step < 500; step++) {
            scene = physics.step(scene, shafts);
            List<Disc> bodies = bodies(world, scene);
            for (int i = 0; i < bodies.size(); i++) {
                Disc body = bodies.get(i);
                assertThat(world.contains(body.centre())).isTrue();
                assertThat(world.walls()).noneMatch(body::overlaps);
                for (int j = 0; j < i; j++) {
                    assertThat(body.overlaps(bodies.get(j))).as("%d, %d", i, j).isFalse();
                }
            }
        }
    }

    private static double[][] shafts(List<Double> speeds) {
        double[][] shafts = new double[3][];
        for (int i = 0; i < shafts.length; i++) {
            shafts[i] = new double[] {speeds.get(2 * i), speeds.get(2 * i + 1), 0};
        }
        return shafts;
    }

    private static List<Disc> bodies(World world, Scene scene) {
        List<Disc> bodies = new ArrayList<>();
        for (int i = 0; i < world.robots().size(); i++) {
            bodies.add(world.robots().get(i).kind().body(scene.robots().get(i).pose()));
        }
        for (int i = 0; i < world.things().size(); i++) {
            bodies.add(world.things().get(i).at(scene.things().get(i).place()));
        }
        return bodies;
    }

    /** Nothing bounces, and nothing moves by itself. */
    @Tag("slow")
    @Property(tries = 100)
    void energyComesFromMotorsAlone(
            @ForAll @Size(6) List<@DoubleRange(min = -900, max = 900) Double> speeds,
            @ForAll @LongRange(min = 0, max = 1000) long seed) {
        assertThatEnergyFalls(speeds, seed);
    }

    @ParameterizedTest
    @CsvFileSource(files = "world/src/test/resources/world/push/crowd.csv", numLinesToSkip = 1)
    void energyComesFromMotorsAloneWhereOnceItDidNot(ArgumentsAccessor row) {
        List<Double> speeds = IntStream.range(0, 6).mapToObj(row::getDouble).toList();
        assertThatEnergyFalls(speeds, row.getLong(6));
    }

    /**
     * From when motors stand, all bodies together have ever less energy, and the floor stops what
     * nobody touches. What the ball pushes, which the floor does not hold, may move as long as the
     * ball does.
     */
    private static void assertThatEnergyFalls(List<Double> speeds, long seed) {
        World world = Worlds.of(CROWD);
        Physics physics = new Physics(world, seed);
        Scene scene = driven(physics, speeds);
        for (int step = 0; step < 300; step++) {
            Scene before = scene;
            scene = physics.step(before, STILL);
            assertThat(energy(world, scene))
                    .isLessThanOrEqualTo(energy(world, before) * (1 + 1e-9));
            for (int i = 0; i < world.things().size(); i++) {
                double held = world.things().get(i).friction() * GRAVITY * Physics.STEP / 1000;
                double free = speed(before.things().get(i)) - held;
                if (!isTouched(world, scene, i)) {
                    assertThat(speed(scene.things().get(i)))
                            .as("thing %d", i)
                            .isLessThanOrEqualTo(Math.max(0, free) + 1e-9);
                }
            }
        }
    }

    private static Scene driven(Physics physics, List<Double> speeds) {
        Scene scene = physics.start();
        for (int step = 0; step < 200; step++) {
            scene = physics.step(scene, shafts(speeds));
        }
        return scene;
    }

    private static double speed(ThingState thing) {
        return Math.hypot(thing.along(), thing.across());
    }

    /** Whether something may have pushed it: round bodies part a little as they pass each other. */
    private static boolean isTouched(World world, Scene scene, int thing) {
        List<Disc> others = bodies(world, scene);
        Disc body = others.remove(world.robots().size() + thing);
        Disc near = new Disc(body.centre(), body.radius() + PASSING);
        double x = body.centre().x();
        double y = body.centre().y();
        return others.stream().anyMatch(near::overlaps)
                || world.walls().stream().anyMatch(near::overlaps)
                || Math.min(x, world.width() - x) < PASSING
                || Math.min(y, world.depth() - y) < PASSING;
    }

    /** Where the floor holds all of them. */
    @Tag("slow")
    @Property(tries = 100)
    void thingsThatNobodyDrivesStandInTheEnd(
            @ForAll @Size(6) List<@DoubleRange(min = -900, max = 900) Double> speeds,
            @ForAll @LongRange(min = 0, max = 1000) long seed) {
        Physics physics = new Physics(Worlds.of(CROWD.replace(" friction 0", "")), seed);
        Scene scene = driven(physics, speeds);
        for (int step = 0; step < 300; step++) {
            scene = physics.step(scene, STILL);
        }
        assertThat(scene.things()).allMatch(thing -> speed(thing) < 1e-6);
    }

    private static double energy(World world, Scene scene) {
        double energy = 0;
        for (int i = 0; i < world.robots().size(); i++) {
            RobotState robot = scene.robots().get(i);
            double speed = (robot.left() + robot.right()) / 2;
            energy += world.robots().get(i).kind().mass() * speed * speed / 2;
        }
        for (int i = 0; i < world.things().size(); i++) {
            ThingState thing = scene.things().get(i);
            double square = thing.along() * thing.along() + thing.across() * thing.across();
            energy += world.things().get(i).mass() * square / 2;
        }
        return energy;
    }

    /** A robot may really stand a little beside its place, and where a thing lies. */
    @Test
    void bodiesThatOverlapGoApartAndTakeNoSpeedWithThem() {
        World world =
                Worlds.of(
                        "floor 2000 1000\nnoise place 5\nrobot one rover at 300 500\n"
                                + "thing ball at 431 500 body 50 300 friction 0\n"
                                + Worlds.ROVER);
        // With this seed the robot stands too near.
        Physics physics = new Physics(world, 3);
        Scene scene = physics.start();
        assertThat(gap(scene)).isNegative();
        for (int step = 0; step < 100; step++) {
            scene = physics.step(scene, STILL);
            assertThat(scene.things().get(0).stands()).isTrue();
        }
        assertThat(gap(scene)).isCloseTo(0.01, within(1e-6));
    }

    /** What 60 rounds leave unsettled makes them come no nearer in the long run. */
    @Test
    void bodiesPressedTogetherKeepTheirDistance() {
        World world =
                Worlds.of(
                        "floor 2000 1000\nnoise none\nwall 1000 200  1000 800\n"
                                + "robot one rover at 700 500\n"
                                + "thing box at 850 500 body 50 100\n"
                                + Worlds.ROVER);
        Physics physics = new Physics(world, 1);
        Scene scene = physics.start();
        for (int step = 0; step < 500; step++) {
            scene = physics.step(scene, new double[][] {{900, 900, 0}});
            assertThat(gap(scene)).isGreaterThan(0.009);
        }
        assertThat(scene.things().get(0).place().x()).isCloseTo(949.99, within(1e-6));
    }

    /** Between the only robot and the only thing. */
    private static double gap(Scene scene) {
        Point robot = scene.robots().get(0).pose().point();
        return robot.distance(scene.things().get(0).place()) - 80 - 50;
    }

    /** Where neither floor nor motors do anything, what one has lost the other has. */
    @Tag("slow")
    @Property(tries = 100)
    void anImpactKeepsMomentum(
            @ForAll @DoubleRange(min = 50, max = 5000) double mass,
            @ForAll @DoubleRange(min = 100, max = 360) double speed) {
        World world =
                Worlds.of(
                        "floor 3000 1000\nnoise none\nrobot one rover at 300 500\n"
                                + "thing ball at 900 500 body 50 %.3f friction 0\n".formatted(mass)
                                + Worlds.ROVER);
        Physics physics = new Physics(world, 1);
        Scene scene = physics.start();
        double[][] shafts = {{speed, speed, 0}};
        while (scene.things().get(0).along() == 0) {
            scene = physics.step(scene, shafts);
        }
        // Two steps: in the first one the robot comes to the ball, in the second one it pushes.
        scene = physics.step(scene, shafts);
        double before = 900 * speed * Math.PI * 56 / 360;
        RobotState robot = scene.robots().get(0);
        double after = 900 * robot.left() + mass * scene.things().get(0).along();
        // Its motors have pulled meanwhile, by at most what they would a robot that stands.
        assertThat(after).isBetween(before * 0.999, before * 1.45);
        assertThat(robot.left()).isCloseTo(scene.things().get(0).along(), within(1.0));
    }

    /** To the last bit. */
    @Property(tries = 20)
    void aThingFarAwayChangesNothing(
            @ForAll @Size(6) List<@DoubleRange(min = -900, max = 900) Double> speeds,
            @ForAll @LongRange(min = 0, max = 1000) long seed) {
        String robots =
                "robot one rover at 300 300\nrobot two rover at 700 300\n"
                        + "robot three rover at 500 800\n"
                        + Worlds.ROVER;
        World without = Worlds.of("floor 9000 1000\nwall 1000 0  1000 1000\n" + robots);
        World with =
                Worlds.of(
                        "floor 9000 1000\nwall 1000 0  1000 1000\n"
                                + "thing box at 8000 500 body 50 500\n"
                                + robots);
        Physics one = new Physics(without, seed);
        Physics other = new Physics(with, seed);
        Scene scene = one.start();
        Scene same = other.start();
        for (int step = 0; step < 300; step++) {
            scene = one.step(scene, shafts(speeds));
            same = other.step(same, shafts(speeds));
            assertThat(same.robots()).isEqualTo(scene.robots());
            assertThat(same.happenings()).isEqualTo(scene.happenings());
        }
    }

    /** A bumper feels it, and no collision is told of. */
    @Test
    void whoPushesSaysSoOnce() {
        World world =
                Worlds.of(
                        "floor 2000 1000\nnoise none\nrobot one rover at 300 500\n"
                                + "thing box at 600 500 body 50 300\n"
                                + Worlds.ROVER);
        Physics physics = new Physics(world, 1);
        Scene scene = physics.start();
        List<Scene.Happening> happenings = new ArrayList<>();
        for (int step = 0; step < 400; step++) {
            scene = physics.step(scene, new double[][] {{360, 360, 0}});
            happenings.addAll(scene.happenings());
        }
        assertThat(happenings)
                .containsExactly(new Scene.Happening(Scene.Happening.What.PUSH, "one", "box"));
        Device.Bumper bumper = new Device.Bumper(3);
        Senses senses = new Senses(world, Seeds.of(1));
        assertThat(senses.read(scene, 0, bumper)).isEqualTo(1);
        assertThat(senses.read(physics.start(), 0, bumper)).isZero();
    }

    @Test
    void thingsStandOnTheFloorAndInNothing() {
        String floor = "floor 1000 1000\nwall 500 0  500 500\nrobot one rover at 300 300\n";
        assertThat(
                        messages(
                                floor
                                        + "thing a at 20 500 body 50 100\n"
                                        + "thing b at 320 300 body 50 100\n"
                                        + "thing c at 520 100 body 50 100\n"
                                        + "thing d at 800 800 body 50 100\n"
                                        + "thing e at 810 800 body 50 100\n"))
                .containsExactly(
                        "thing 'a', of radius 50, reaches over the edge of the floor of 1000 x"
                                + " 1000 mm: it stands at (20, 500)",
                        "thing 'b' and robot 'one' are in one place: their bodies overlap",
                        "thing 'c' stands in a wall",
                        "things 'e' and 'd' are in one place: their bodies overlap");
        assertThat(messages(floor + "thing one at 800 800 body 50 100\n"))
                .containsExactly("there are two 'one'");
        assertThat(messages(floor + "thing box at 800 800 body 50 100 friction 3\n"))
                .containsExactly("'3' is not a share of its weight, 0 to 2");
    }

    private static List<String> messages(String text) {
        return WorldParser.parse(new SourceFile("test.world", text + Worlds.ROVER))
                .findings()
                .stream()
                .map(Diagnostic::message)
                .toList();
    }

    @Test
    void anUltrasonicSensorSeesThings() {
        World world =
                Worlds.of(
                        "floor 2000 1000\nnoise none\nrobot one rover at 300 500\n"
                                + "thing box at 800 500 body 50 300\n"
                                + Worlds.ROVER);
        Senses senses = new Senses(world, Seeds.of(1));
        Device.Sensor eye = world.robots().get(0).kind().sensors().get(0);
        Scene start = new Physics(world, 1).start();
        assertThat(senses.read(start, 0, eye)).isEqualTo(38);
    }
}
