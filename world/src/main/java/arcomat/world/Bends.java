package arcomat.world;

import arcomat.world.arithmetic.Arc;
import arcomat.world.arithmetic.Circle;
import arcomat.world.arithmetic.Tangent;

import java.util.ArrayList;
import java.util.List;

/** Rounds the corners of a line, as a robot that follows it needs them. */
final class Bends {
    /** In radians: an arc is drawn as so short chords that nobody sees them. */
    private static final double STEP = Circle.radians(5);

    private Bends() {}

    /**
     * The pieces of a line through some points.
     *
     * @param radius of the bends in mm; smaller where the points are too close; 0 for corners
     * @param ring whether the line returns to its first point
     */
    static List<Segment> pieces(List<Point> points, double radius, boolean ring) {
        int size = points.size();
        List<Point> outline = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            boolean end = !ring && (i == 0 || i == size - 1);
            if (end || radius == 0) {
                outline.add(points.get(i));
            } else {
                Point before = points.get((i + size - 1) % size);
                round(before, points.get(i), points.get((i + 1) % size), radius, outline);
            }
        }
        if (ring) {
            outline.add(outline.get(0));
        }
        List<Segment> pieces = new ArrayList<>();
        for (int i = 1; i < outline.size(); i++) {
            pieces.add(new Segment(outline.get(i - 1), outline.get(i)));
        }
        return pieces;
    }

    private static void round(
            Point before, Point corner, Point after, double radius, List<Point> outline) {
        double in = Arc.atan2(corner.y() - before.y(), corner.x() - before.x());
        double out = Arc.atan2(after.y() - corner.y(), after.x() - corner.x());
        double turn = Circle.nearest(out - in);
        double half = Math.abs(Tangent.tan(turn / 2));
        double room = Math.min(before.distance(corner), corner.distance(after)) / 2;
        double fitting = half == 0 ? 0 : Math.min(radius, room / half);
        double tangent = fitting * half;
        int steps = Math.max(1, (int) Math.ceil(Math.abs(turn) / STEP));
        double side = Math.signum(turn) * Math.PI / 2;
        Point start = corner.plus(-tangent * Circle.cos(in), -tangent * Circle.sin(in));
        Point centre = start.plus(fitting * Circle.cos(in + side), fitting * Circle.sin(in + side));
        for (int i = 0; i <= steps; i++) {
            double angle = in - side + turn * i / steps;
            outline.add(centre.plus(fitting * Circle.cos(angle), fitting * Circle.sin(angle)));
        }
    }
}
