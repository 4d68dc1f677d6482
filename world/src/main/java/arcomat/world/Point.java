package arcomat.world;

/** A place on the floor, in mm: x to the right, y up. */
public record Point(double x, double y) {
    Point plus(double dx, double dy) {
        return new Point(x + dx, y + dy);
    }

    /** In mm. */
    public double distance(Point other) {
        return distance(x, y, other.x, other.y);
    }

    /** From one place to another, in mm; without objects, for what is asked often. */
    static double distance(double x, double y, double otherX, double otherY) {
        double dx = otherX - x;
        double dy = otherY - y;
        return Math.sqrt(dx * dx + dy * dy);
    }
}
