package arcomat.world;

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
}
