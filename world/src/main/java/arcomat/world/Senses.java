package arcomat.world;

import arcomat.world.Scene.RobotState;
import arcomat.world.arithmetic.Circle;

import java.util.stream.IntStream;

/**
 * What sensors see of a scene, each in its own unit: cm, percent, 1 for pressed. Each has an offset
 * of its own, and each reading an error; both come from the seeds.
 */
public final class Senses {
    private static final double DARK = 15;
    private static final double BRIGHT = 75;
    private static final double LAMP_ON = 90;
    private static final double LAMP_OFF = 20;

    /** Radius of what a light sensor sees, in mm. */
    private static final double SPOT = 5;

    /** The cone of the ultrasonic sensor: rays on either side of the middle one. */
    private static final int RAYS = 4;

    private static final double BETWEEN_RAYS = Circle.radians(15.0 / RAYS);

    /** In cm; beyond, no echo comes back. */
    private static final double RANGE = 170;

    private static final int NO_ECHO = 255;
    private static final double BELOW_CHUTE = 5;
    private static final double FLOOR_BELOW_CHUTE = 60;
    private static final double MILLIMETRES = 10;
    private static final int OFFSET = 100;

    private final World world;
    private final Chance chance;

    public Senses(World world, Seeds seeds) {
        this.world = world;
        this.chance = new Chance(seeds);
    }

    /** The reading of a sensor of the robot with this index. */
    public int read(Scene scene, int index, Device.Sensor sensor) {
        return sensor.read(new View(scene, index, sensor.socket()));
    }

    /** What there is for a sensor to see. Its own robot's places are seen from that robot. */
    final class View {
        private final Scene scene;
        private final int index;
        private final int socket;

        private View(Scene scene, int index, int socket) {
            this.scene = scene;
            this.index = index;
            this.socket = socket;
        }

        /** The robot that has the sensor. */
        RobotState robot() {
            return scene.robots().get(index);
        }

        /** The reading of a light sensor that looks at the floor, in percent. */
        int floor(Point mounted) {
            Point place = robot().pose().place(mounted);
            double covered = 0;
            for (World.Line line : world.lines()) {
                // A spot on the edge of a line sees some of both.
                double inside = line.width() / 2 - line.distance(place);
                covered = Math.max(covered, Math.min(1, (inside + SPOT) / (2 * SPOT)));
            }
            return percent(BRIGHT - (BRIGHT - DARK) * covered);
        }

        /** The reading of a light sensor that looks at a lamp, in percent. */
        int lamp(boolean on) {
            return percent(on ? LAMP_ON : LAMP_OFF);
        }

        /**
         * The reading of an ultrasonic sensor, in cm.
         *
         * @param facing in radians from the robot's front to the left
         */
        int echo(Point mounted, double facing) {
            Pose pose = robot().pose();
            Point eye = pose.place(mounted);
            double nearest = Double.POSITIVE_INFINITY;
            for (int ray = -RAYS; ray <= RAYS; ray++) {
                double angle = pose.heading() + facing + ray * BETWEEN_RAYS;
                nearest = Math.min(nearest, hit(eye, Circle.cos(angle), Circle.sin(angle)));
            }
            return centimetres(nearest / MILLIMETRES);
        }

        private double hit(Point eye, double cos, double sin) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int i = 0; i < scene.robots().size(); i++) {
                if (i != index) {
                    Disc body = world.robots().get(i).kind().body(scene.robots().get(i).pose());
                    nearest = Math.min(nearest, body.hit(eye, cos, sin));
                }
            }
            for (int i = 0; i < scene.drinkers().size(); i++) {
                if (scene.drinkers().get(i).present()) {
                    Disc legs = world.drinkers().get(i).legs();
                    nearest = Math.min(nearest, legs.hit(eye, cos, sin));
                }
            }
            for (int i = 0; i < scene.things().size(); i++) {
                Disc thing = world.things().get(i).at(scene.things().get(i).place());
                nearest = Math.min(nearest, thing.hit(eye, cos, sin));
            }
            for (Segment wall : world.walls()) {
                nearest = Math.min(nearest, wall.hit(eye, cos, sin));
            }
            return nearest;
        }

        /** The reading of a sensor that looks down where a robot may stand, in cm. */
        int below(Point mounted) {
            Point place = robot().pose().place(mounted);
            boolean stands = others().anyMatch(i -> place(i).distance(place) < kind(i).radius());
            return centimetres(stands ? BELOW_CHUTE : FLOOR_BELOW_CHUTE);
        }

        /** Whether another robot has a cup at a place. */
        boolean isCupAt(Point mounted) {
            Point place = robot().pose().place(mounted);
            return others().filter(i -> scene.robots().get(i).cup() != World.Cup.NONE)
                    .anyMatch(i -> kind(i).holdsAt(scene.robots().get(i).pose(), place));
        }

        private IntStream others() {
            return IntStream.range(0, scene.robots().size()).filter(i -> i != index);
        }

        private Kind kind(int robot) {
            return world.robots().get(robot).kind();
        }

        private Point place(int robot) {
            return scene.robots().get(robot).pose().point();
        }

        private int percent(double ideal) {
            double reading = ideal + error(world.noise().light());
            return rounded(Math.max(0, Math.min(100, reading)));
        }

        private int centimetres(double ideal) {
            double reading = ideal + error(world.noise().distance());
            return reading > RANGE ? NO_ECHO : rounded(Math.max(0, reading));
        }

        /** Rounding of a browser differs where Java's is hard to follow; this is the same. */
        private static int rounded(double reading) {
            return (int) Math.floor(reading + 0.5);
        }

        private double error(double deviation) {
            if (deviation == 0) {
                return 0;
            }
            double offset = chance.normal(index, OFFSET + socket, Chance.ONCE);
            return deviation * (2 * offset + chance.normal(index, OFFSET + socket, scene.tick()));
        }
    }
}
