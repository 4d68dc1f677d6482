package arcomat.world;

import arcomat.world.World.Cup;

import java.util.List;

/**
 * The world at a moment.
 *
 * @param tick steps since it began
 * @param robots in the order of the world's
 * @param drinkers in the order of the world's
 * @param things in the order of the world's
 * @param happenings what happened in the last step
 */
public record Scene(
        long tick,
        List<RobotState> robots,
        List<DrinkerState> drinkers,
        List<ThingState> things,
        List<Happening> happenings) {
    public Scene {
        robots = List.copyOf(robots);
        drinkers = List.copyOf(drinkers);
        things = List.copyOf(things);
        happenings = List.copyOf(happenings);
    }

    /** Milliseconds since the world began. */
    public int time() {
        return (int) (tick * Physics.STEP);
    }

    /** Cups that drinkers have taken. */
    public int delivered() {
        int cups = 0;
        for (DrinkerState drinker : drinkers) {
            cups += drinker.cups();
        }
        return cups;
    }

    /**
     * A robot.
     *
     * @param left speed over the floor at the left wheel, in mm per second
     * @param right likewise
     * @param touching whether it pushes against something that does not move
     * @param pushing whether it pushes a thing
     * @param angle of the motor that moves its slide or finger, in degrees since the start
     * @param turnedOut whether slide or finger have done their work and are not yet back
     * @param stock cups in its magazine
     * @param brewing seconds that its coffee machine still needs; 0 if it is idle
     */
    public record RobotState(
            Pose pose,
            double left,
            double right,
            boolean touching,
            boolean pushing,
            Cup cup,
            double angle,
            boolean turnedOut,
            int stock,
            double brewing) {
        RobotState with(Cup other) {
            return new RobotState(
                    pose, left, right, touching, pushing, other, angle, turnedOut, stock, brewing);
        }

        RobotState moved(Pose to, double leftSpeed, double rightSpeed, boolean touches) {
            return new RobotState(
                    to,
                    leftSpeed,
                    rightSpeed,
                    touches,
                    pushing,
                    cup,
                    angle,
                    turnedOut,
                    stock,
                    brewing);
        }

        RobotState rolling(double leftSpeed, double rightSpeed) {
            return moved(pose, leftSpeed, rightSpeed, touching);
        }

        RobotState pushing(boolean pushes) {
            return new RobotState(
                    pose, left, right, touching, pushes, cup, angle, turnedOut, stock, brewing);
        }

        RobotState turned(double degrees, boolean out) {
            return new RobotState(
                    pose, left, right, touching, pushing, cup, degrees, out, stock, brewing);
        }

        RobotState supplied(int cups, double seconds) {
            return new RobotState(
                    pose, left, right, touching, pushing, cup, angle, turnedOut, cups, seconds);
        }

        boolean stands() {
            return Math.abs(left) + Math.abs(right) < 10;
        }
    }

    /**
     * A drinker.
     *
     * @param present whether they stand on their spot
     * @param pause seconds until they want coffee again
     * @param taking seconds that they have been reaching for a cup
     * @param cups that they have had
     */
    public record DrinkerState(boolean present, double pause, double taking, int cups) {}

    /**
     * A thing.
     *
     * @param place of its middle
     * @param along its speed along x, in mm per second
     * @param across its speed along y
     */
    public record ThingState(Point place, double along, double across) {
        boolean stands() {
            return along == 0 && across == 0;
        }
    }

    /**
     * Something that people would tell of.
     *
     * @param who name of a robot
     * @param whom name of another robot, of a drinker or of a thing; empty where there is none
     */
    public record Happening(What what, String who, String whom) {
        /** What can happen. */
        public enum What {
            /** A robot has run into something. */
            COLLISION,
            /** A robot has begun to push a thing. */
            PUSH,
            /** A robot has got a cup. */
            CUP_GIVEN,
            /** A cup has fallen on the floor. */
            CUP_LOST,
            /** The cup of a robot has been filled. */
            COFFEE_POURED,
            /** Coffee has run on the floor. */
            COFFEE_SPILT,
            /** A drinker has taken a cup. */
            COFFEE_TAKEN
        }
    }
}
