package arcomat.world;

import arcomat.world.Scene.RobotState;

/**
 * What sensors see of a scene, each in its own unit: cm, percent, 1 for pressed. Each has an offset
 * of its own, and each reading an error; both come from the seed.
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

    private static final double BETWEEN_RAYS = Math.toRadians(15.0 / RAYS);

    /** In cm; beyond, no echo comes back. */
    private static final double RANGE = 170;

    private static final int NO_ECHO = 255;
    private static final double BELOW_CHUTE = 5;
    private static final double FLOOR_BELOW_CHUTE = 60;
    private static final double MILLIMETRES = 10;
    private static final int OFFSET = 100;

    private final World world;
    private final Chance chance;

    public Senses(World world, long seed) {
        this.world = world;
        this.chance = new Chance(seed);
    }

    /** The reading of a sensor of the robot with this index. */
    public int read(Scene scene, int index, Device.Sensor sensor) {
        RobotState state = scene.robots().get(index);
        if (sensor instanceof Device.Light light) {
            return percent(floor(state.pose().place(light.place())), index, sensor, scene);
        } else if (sensor instanceof Device.Lamp) {
            double lamp = state.brewing() == 0 ? LAMP_ON : LAMP_OFF;
            return percent(lamp, index, sensor, scene);
        } else if (sensor instanceof Device.Ultrasonic ultrasonic) {
            return centimetres(echo(scene, index, ultrasonic), index, sensor, scene);
        } else if (sensor instanceof Device.Chute chute) {
            boolean below = isBelow(state.pose().place(chute.place()), index, scene);
            return centimetres(below ? BELOW_CHUTE : FLOOR_BELOW_CHUTE, index, sensor, scene);
        }
        return isPressed(sensor, state, index, scene) ? 1 : 0;
    }

    private boolean isPressed(Device.Sensor sensor, RobotState state, int index, Scene scene) {
        if (sensor instanceof Device.Holder) {
            return state.cup() == Cup.FULL;
        } else if (sensor instanceof Device.Magazine) {
            return state.stock() > 0;
        } else if (sensor instanceof Device.Feeler feeler) {
            return isCupAt(state.pose().place(feeler.place()), index, scene);
        }
        return state.touching();
    }

    /** Brightness in percent; a spot on the edge of a line sees some of both. */
    private double floor(Point place) {
        double covered = 0;
        for (Way line : world.lines()) {
            double inside = line.width() / 2 - line.distance(place);
            covered = Math.max(covered, Math.min(1, (inside + SPOT) / (2 * SPOT)));
        }
        return BRIGHT - (BRIGHT - DARK) * covered;
    }

    /** In cm. */
    private double echo(Scene scene, int index, Device.Ultrasonic sensor) {
        Pose pose = scene.robots().get(index).pose();
        Point eye = pose.place(sensor.place());
        double nearest = Double.POSITIVE_INFINITY;
        for (int ray = -RAYS; ray <= RAYS; ray++) {
            double angle = pose.heading() + sensor.facing() + ray * BETWEEN_RAYS;
            nearest =
                    Math.min(
                            nearest,
                            hit(scene, index, eye, StrictMath.cos(angle), StrictMath.sin(angle)));
        }
        return nearest / MILLIMETRES;
    }

    private double hit(Scene scene, int index, Point eye, double cos, double sin) {
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
        for (Segment wall : world.walls()) {
            nearest = Math.min(nearest, wall.hit(eye, cos, sin));
        }
        return nearest;
    }

    private boolean isBelow(Point place, int index, Scene scene) {
        for (int i = 0; i < scene.robots().size(); i++) {
            double radius = world.robots().get(i).kind().radius();
            Point other = scene.robots().get(i).pose().point();
            if (i != index && other.distance(place) < radius) {
                return true;
            }
        }
        return false;
    }

    private boolean isCupAt(Point place, int index, Scene scene) {
        for (int i = 0; i < scene.robots().size(); i++) {
            RobotState other = scene.robots().get(i);
            if (i != index
                    && other.cup() != Cup.NONE
                    && world.robots().get(i).kind().holdsAt(other.pose(), place)) {
                return true;
            }
        }
        return false;
    }

    private int percent(double ideal, int index, Device.Sensor sensor, Scene scene) {
        double reading = ideal + error(world.noise().light(), index, sensor, scene);
        return (int) Math.round(Math.max(0, Math.min(100, reading)));
    }

    private int centimetres(double ideal, int index, Device.Sensor sensor, Scene scene) {
        double reading = ideal + error(world.noise().distance(), index, sensor, scene);
        return reading > RANGE ? NO_ECHO : (int) Math.round(Math.max(0, reading));
    }

    private double error(double deviation, int index, Device.Sensor sensor, Scene scene) {
        if (deviation == 0) {
            return 0;
        }
        double offset = chance.normal(index, OFFSET + sensor.socket(), -1);
        return deviation
                * (2 * offset + chance.normal(index, OFFSET + sensor.socket(), scene.tick()));
    }
}
