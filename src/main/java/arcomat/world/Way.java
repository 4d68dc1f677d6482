package arcomat.world;

import java.util.List;

/**
 * A dark line on the bright floor.
 *
 * @param width in mm
 */
public record Way(List<Segment> pieces, double width) {
    public Way {
        pieces = List.copyOf(pieces);
    }

    /** From a point to the middle of the line, in mm. */
    double distance(Point point) {
        double nearest = Double.POSITIVE_INFINITY;
        for (Segment piece : pieces) {
            nearest = Math.min(nearest, piece.distance(point));
        }
        return nearest;
    }
}
