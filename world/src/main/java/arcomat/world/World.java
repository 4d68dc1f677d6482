package arcomat.world;

import arcomat.source.Span;

import java.util.List;

/**
 * A world as its text describes it.
 *
 * @param width of the floor, in mm
 * @param depth of the floor, in mm
 * @param seconds that a run takes at most
 * @param goal cups of coffee that are to be delivered; the run ends with the last. 0: no goal
 */
public record World(
        double width,
        double depth,
        int seconds,
        int goal,
        Noise noise,
        List<Line> lines,
        List<Segment> walls,
        List<Robot> robots,
        List<Drinker> drinkers,
        List<Thing> things) {
    public World {
        lines = List.copyOf(lines);
        walls = List.copyOf(walls);
        robots = List.copyOf(robots);
        drinkers = List.copyOf(drinkers);
        things = List.copyOf(things);
    }

    boolean contains(Point point) {
        return point.x() >= 0 && point.x() <= width && point.y() >= 0 && point.y() <= depth;
    }

    boolean contains(Disc disc) {
        Point centre = disc.centre();
        double r = disc.radius();
        return contains(centre.plus(-r, -r)) && contains(centre.plus(r, r));
    }

    /**
     * A robot as the world begins.
     *
     * @param name of its brick
     * @param place where the world says so
     */
    public record Robot(String name, Kind kind, Pose pose, Cup cup, Span place) {
        Disc disc() {
            return kind.body(pose);
        }
    }

    /** What a fetcher has in its holder. */
    public enum Cup {
        NONE(0),
        EMPTY(10),
        FULL(200);

        /** In grams. */
        final double mass;

        Cup(double mass) {
            this.mass = mass;
        }
    }

    /**
     * Somebody who steps on the line when coffee comes, takes it and goes away to drink it.
     *
     * @param spot where they step
     * @param thirst seconds from one cup to the wish for the next
     */
    public record Drinker(String name, Point spot, double thirst, Span place) {
        /** Of the legs of a person, in mm. */
        private static final double RADIUS = 100;

        /** What they fill of the floor. */
        Disc legs() {
            return new Disc(spot, RADIUS);
        }
    }

    /**
     * Something round that lies on the floor, and moves when it is pushed.
     *
     * @param spot where its middle is when the world begins
     * @param radius in mm
     * @param mass in grams
     * @param friction the share of its weight by which the floor holds it
     */
    public record Thing(
            String name, Point spot, double radius, double mass, double friction, Span place) {
        /** What it fills of the floor at a place. */
        Disc at(Point middle) {
            return new Disc(middle, radius);
        }
    }

    /**
     * A dark line on the bright floor.
     *
     * @param width in mm
     */
    public record Line(List<Segment> pieces, double width) {
        public Line {
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

    /**
     * How far the world is from its ideal; standard deviations.
     *
     * @param light percent: of a reading, and twice that of a sensor as a whole
     * @param distance cm, likewise
     * @param wheels percent by which a wheel is larger or smaller than its mate
     * @param place mm by which a robot is set down beside its place
     * @param heading degrees by which it looks elsewhere
     */
    public record Noise(
            double light, double distance, double wheels, double place, double heading) {
        public static final Noise USUAL = new Noise(1, 1, 0.5, 4, 1.5);
        public static final Noise NONE = new Noise(0, 0, 0, 0, 0);
    }
}
