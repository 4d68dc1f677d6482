package arcomat.world;

/** A straight piece of a line or wall. */
public record Segment(Point from, Point to) {
    /** From a point to the nearest one of the segment, in mm. */
    double distance(Point point) {
        return distance(point.x(), point.y());
    }

    /** The place of the segment that is nearest to another one. */
    Point nearest(Point point) {
        double dx = to.x() - from.x();
        double dy = to.y() - from.y();
        double part = part(point.x(), point.y(), dx, dy);
        return from.plus(part * dx, part * dy);
    }

    /** From a place to the nearest one of the segment, in mm. */
    double distance(double x, double y) {
        double dx = to.x() - from.x();
        double dy = to.y() - from.y();
        double part = part(x, y, dx, dy);
        return Point.distance(x, y, from.x() + part * dx, from.y() + part * dy);
    }

    /** How much of the segment lies before the place of it that is nearest to another one. */
    private double part(double x, double y, double dx, double dy) {
        double square = dx * dx + dy * dy;
        double along = (x - from.x()) * dx + (y - from.y()) * dy;
        return square == 0 ? 0 : Math.max(0, Math.min(1, along / square));
    }

    /** How far a ray goes before it meets the segment; infinite where it does not. */
    double hit(Point eye, double cos, double sin) {
        double dx = to.x() - from.x();
        double dy = to.y() - from.y();
        double across = cos * dy - sin * dx;
        if (across == 0) {
            return Double.POSITIVE_INFINITY;
        }
        double ex = from.x() - eye.x();
        double ey = from.y() - eye.y();
        double along = (ex * dy - ey * dx) / across;
        double part = (ex * sin - ey * cos) / across;
        return along >= 0 && part >= 0 && part <= 1 ? along : Double.POSITIVE_INFINITY;
    }
}
