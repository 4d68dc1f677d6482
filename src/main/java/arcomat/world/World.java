package arcomat.world;

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
        List<Way> lines,
        List<Segment> walls,
        List<Robot> robots,
        List<Drinker> drinkers) {
    public World {
        lines = List.copyOf(lines);
        walls = List.copyOf(walls);
        robots = List.copyOf(robots);
        drinkers = List.copyOf(drinkers);
    }

    boolean contains(Point point) {
        return point.x() >= 0 && point.x() <= width && point.y() >= 0 && point.y() <= depth;
    }

    boolean contains(Disc disc) {
        Point centre = disc.centre();
        double r = disc.radius();
        return contains(centre.plus(-r, -r)) && contains(centre.plus(r, r));
    }
}
