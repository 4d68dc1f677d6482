package arcomat.world;

/** The outline of a body: round, so that turning on the spot changes nothing. In mm. */
record Disc(Point centre, double radius) {
    boolean overlaps(Disc other) {
        return centre.distance(other.centre) < radius + other.radius;
    }

    boolean overlaps(Segment wall) {
        return wall.distance(centre) < radius;
    }

    /** How far a ray goes before it meets the disc; infinite where it does not. */
    double hit(Point eye, double cos, double sin) {
        double dx = centre.x() - eye.x();
        double dy = centre.y() - eye.y();
        double along = dx * cos + dy * sin;
        double square = radius * radius - (dx * dx + dy * dy - along * along);
        if (along < 0 || square < 0) {
            return Double.POSITIVE_INFINITY;
        }
        return Math.max(0, along - Math.sqrt(square));
    }
}
