package arcomat.world;

import arcomat.world.World.Cup;

import java.util.List;

/**
 * The world at a moment.
 *
 * @param tick steps since it began
 * @param robots in the order of the world's
 * @param drinkers in the order of the world's
 * @param happenings what happened in the last step
 */
public record Scene(
        long tick,
        List<RobotState> robots,
        List<DrinkerState> drinkers,
        List<Happening> happenings) {
    public Scene {
        robots = List.copyOf(robots);
        drinkers = List.copyOf(drinkers);
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
     * @param touching whether it pushes against something
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
            Cup cup,
            double angle,
            boolean turnedOut,
            int stock,
            double brewing) {
        RobotState with(Cup other) {
            return new RobotState(
                    pose, left, right, touching, other, angle, turnedOut, stock, brewing);
        }

        RobotState moved(Pose to, double leftSpeed, double rightSpeed, boolean touches) {
            return new RobotState(
                    to, leftSpeed, rightSpeed, touches, cup, angle, turnedOut, stock, brewing);
        }

        RobotState turned(double degrees, boolean out) {
            return new RobotState(pose, left, right, touching, cup, degrees, out, stock, brewing);
        }

        RobotState supplied(int cups, double seconds) {
            return new RobotState(
                    pose, left, right, touching, cup, angle, turnedOut, cups, seconds);
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
     * Something that people would tell of.
     *
     * @param who name of a robot
     * @param whom name of another robot or of a drinker; empty where there is none
     */
    public record Happening(What what, String who, String whom) {
        /** What can happen. */
        public enum What {
            /** A robot has run into something. */
            COLLISION,
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
