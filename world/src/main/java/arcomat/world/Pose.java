package arcomat.world;

import arcomat.world.arithmetic.Circle;

/**
 * Where a robot stands and looks.
 *
 * @param x in mm
 * @param y in mm
 * @param heading in radians, 0 along x, growing to the left
 */
public record Pose(double x, double y, double heading) {
    public Point point() {
        return new Point(x, y);
    }

    /** From the middle of the robot to a place, in mm. */
    double distance(double otherX, double otherY) {
        return Point.distance(x, y, otherX, otherY);
    }

    /** The place of something that is fixed to the robot. */
    public Point place(Point mounted) {
        double cos = Circle.cos(heading);
        double sin = Circle.sin(heading);
        return new Point(
                x + mounted.x() * cos - mounted.y() * sin,
                y + mounted.x() * sin + mounted.y() * cos);
    }

    /**
     * Where two wheels take it. Over so short a time the way is as good as the chord in the middle
     * direction.
     *
     * @param left in mm per second
     * @param right in mm per second
     * @param track from wheel to wheel, in mm
     * @param seconds a small fraction of one
     */
    Pose driven(double left, double right, double track, double seconds) {
        double turn = (right - left) / track * seconds;
        double way = (left + right) / 2 * seconds;
        double middle = heading + turn / 2;
        return new Pose(x + way * Circle.cos(middle), y + way * Circle.sin(middle), heading + turn);
    }
}
