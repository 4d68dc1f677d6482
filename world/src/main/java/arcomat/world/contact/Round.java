package arcomat.world.contact;

/**
 * A round body's place.
 *
 * @param x of its middle
 * @param y of its middle
 */
public record Round(double x, double y, double radius) {
    /** Between two of them; below 0 where they overlap. */
    public double gap(Round other) {
        return distance(other.x, other.y) - radius - other.radius;
    }

    /** From the middle to a point. */
    double distance(double pointX, double pointY) {
        double dx = pointX - x;
        double dy = pointY - y;
        return Math.sqrt(dx * dx + dy * dy);
    }
}
