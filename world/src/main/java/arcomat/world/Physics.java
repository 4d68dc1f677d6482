package arcomat.world;

import arcomat.world.Kind.Wheels;
import arcomat.world.Scene.DrinkerState;
import arcomat.world.Scene.Happening;
import arcomat.world.Scene.Happening.What;
import arcomat.world.Scene.RobotState;
import arcomat.world.Scene.ThingState;
import arcomat.world.World.Cup;
import arcomat.world.World.Drinker;
import arcomat.world.World.Noise;
import arcomat.world.World.Robot;
import arcomat.world.arithmetic.Circle;
import arcomat.world.arithmetic.Decay;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * From one scene to the next. What a seed decides is decided once, when the world begins: how far
 * robots stand beside their places and how unequal their wheels are.
 */
public final class Physics {
    /** Length of a step, in milliseconds. */
    public static final int STEP = 10;

    private static final double SECONDS = STEP / 1000.0;

    /** Who pushes against something is less than this away from it, in mm. */
    private static final double PUSH = 5;

    /** Of the usual program of a robot, in milliseconds. */
    private static final double CYCLE = 100;

    /** How hard tyres pull: grams per second. A robot of 900 g is up to speed in 0.1 s. */
    private static final double GRIP = 20_000;

    private final World world;
    private final double[] leftRoll;
    private final double[] rightRoll;

    /** How much of the speed of its wheels a robot takes up in a step, with each cup. */
    private final double[][] takenUp;

    private final long[] switchedOn;
    private final Scene start;
    private final Pushing pushing;
    private final Stations stations;
    private final People people;

    public Physics(World world, long seed) {
        this.world = world;
        Chance chance = new Chance(Seeds.of(seed));
        int count = world.robots().size();
        leftRoll = new double[count];
        rightRoll = new double[count];
        takenUp = new double[count][];
        switchedOn = new long[count];
        List<RobotState> robots = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Robot robot = world.robots().get(i);
            int mate = i;
            takenUp[i] = takenUp(robot.kind().mass());
            robot.kind()
                    .wheels()
                    .ifPresent(
                            wheels -> {
                                double more = drawn(chance, mate, Purpose.WHEELS) / 200;
                                leftRoll[mate] = wheels.roll() * (1 + more);
                                rightRoll[mate] = wheels.roll() * (1 - more);
                            });
            robots.add(placed(robot, i, chance));
            double share = (i + chance.even(i, Purpose.SWITCHED_ON.ordinal())) / count;
            switchedOn[i] = (long) (CYCLE * share);
        }
        List<DrinkerState> drinkers = new ArrayList<>();
        world.drinkers().forEach(drinker -> drinkers.add(new DrinkerState(false, 0, 0, 0)));
        start = new Scene(0, robots, drinkers, Pushing.start(world), List.of());
        pushing = new Pushing(world, SECONDS);
        stations = new Stations(world);
        people = new People(world);
    }

    private static double[] takenUp(double mass) {
        return Arrays.stream(Cup.values())
                .mapToDouble(cup -> 1 - Decay.exp(-SECONDS * GRIP / (mass + cup.mass)))
                .toArray();
    }

    private double drawn(Chance chance, int robot, Purpose purpose) {
        Noise noise = world.noise();
        double deviation =
                switch (purpose) {
                    case WHEELS -> noise.wheels();
                    case X, Y -> noise.place();
                    case HEADING -> Circle.radians(noise.heading());
                    case SWITCHED_ON -> 0;
                };
        return deviation * chance.normal(robot, purpose.ordinal(), Chance.ONCE);
    }

    private enum Purpose {
        WHEELS,
        X,
        Y,
        HEADING,
        SWITCHED_ON
    }

    /** Robots that stand are screwed to their places. */
    private RobotState placed(Robot robot, int index, Chance chance) {
        Pose pose = robot.pose();
        if (robot.kind().wheels().isPresent()) {
            pose =
                    new Pose(
                            pose.x() + drawn(chance, index, Purpose.X),
                            pose.y() + drawn(chance, index, Purpose.Y),
                            pose.heading() + drawn(chance, index, Purpose.HEADING));
        }
        int stock = robot.kind().find(Device.Magazine.class).map(Device.Magazine::cups).orElse(0);
        return new RobotState(pose, 0, 0, false, false, robot.cup(), 0, false, stock, 0);
    }

    /**
     * When a robot is switched on, in milliseconds: one after the other, and so that no two of them
     * work in step.
     *
     * @param index of the robot
     */
    public long switchedOn(int index) {
        return switchedOn[index];
    }

    /** The scene before the first step. */
    public Scene start() {
        return start;
    }

    /**
     * The next scene.
     *
     * @param shafts speed of motor m of robot r in degrees per second at {@code [r][m - 1]}
     */
    public Scene step(Scene scene, double[][] shafts) {
        List<Happening> happenings = new ArrayList<>();
        List<RobotState> robots = new ArrayList<>(scene.robots());
        for (int i = 0; i < robots.size(); i++) {
            if (world.robots().get(i).kind().wheels().isPresent()) {
                robots.set(i, pulled(i, robots.get(i), shafts[i]));
            }
        }
        Pushing.Meeting meeting = pushing.meet(scene, robots, shafts, happenings);
        for (int i = 0; i < robots.size(); i++) {
            if (world.robots().get(i).kind().wheels().isPresent()) {
                robots.set(
                        i,
                        driven(i, meeting.partings().get(i), robots, scene.drinkers(), happenings));
            }
        }
        List<ThingState> things = pushing.move(scene, robots, meeting);
        stations.step(robots, shafts, SECONDS, happenings);
        List<DrinkerState> drinkers =
                people.step(scene.drinkers(), robots, things, SECONDS, happenings);
        return new Scene(scene.tick() + 1, robots, drinkers, things, happenings);
    }

    /** With the speeds to which its wheels have pulled it. */
    private RobotState pulled(int index, RobotState state, double[] shafts) {
        Wheels wheels = world.robots().get(index).kind().wheels().orElseThrow();
        double share = takenUp[index][state.cup().ordinal()];
        double left = shafts[wheels.left() - 1] * leftRoll[index];
        double right = shafts[wheels.right() - 1] * rightRoll[index];
        return state.rolling(
                state.left() + (left - state.left()) * share,
                state.right() + (right - state.right()) * share);
    }

    /**
     * @param parting by how much it moves faster than it keeps moving
     */
    private RobotState driven(
            int index,
            double parting,
            List<RobotState> robots,
            List<DrinkerState> drinkers,
            List<Happening> happenings) {
        Robot robot = world.robots().get(index);
        RobotState state = robots.get(index);
        double track = robot.kind().wheels().orElseThrow().track();
        double left = state.left();
        double right = state.right();
        Pose pose = state.pose().driven(left + parting, right + parting, track, SECONDS);
        String obstacle = obstacle(index, pose, 0, robots, drinkers);
        if (obstacle.isEmpty()) {
            boolean still =
                    state.touching() && !obstacle(index, pose, PUSH, robots, drinkers).isEmpty();
            return state.moved(pose, left, right, still);
        }
        if (!state.touching()) {
            happenings.add(new Happening(What.COLLISION, robot.name(), obstacle));
        }
        Pose held = new Pose(state.pose().x(), state.pose().y(), pose.heading());
        return state.moved(held, 0, 0, true);
    }

    /** The name of what is less than a gap away from a robot; empty where the way is free. */
    private String obstacle(
            int index,
            Pose pose,
            double gap,
            List<RobotState> robots,
            List<DrinkerState> drinkers) {
        Disc body = new Disc(pose.point(), world.robots().get(index).kind().radius() + gap);
        for (int other = 0; other < robots.size(); other++) {
            Robot robot = world.robots().get(other);
            if (other != index && body.overlaps(robot.kind().body(robots.get(other).pose()))) {
                return robot.name();
            }
        }
        for (int i = 0; i < drinkers.size(); i++) {
            Drinker drinker = world.drinkers().get(i);
            if (drinkers.get(i).present() && body.overlaps(drinker.legs())) {
                return drinker.name();
            }
        }
        for (Segment wall : world.walls()) {
            if (body.overlaps(wall)) {
                return "a wall";
            }
        }
        return world.contains(pose.point()) ? "" : "the edge of the floor";
    }
}
