package arcomat.world;

import arcomat.world.Scene.Happening.What;

import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.TreeMap;

/**
 * What a run of a world comes to: as much as a campaign asks of each of its runs. Where a {@link
 * Recording} of the same run says the same, it says the same.
 *
 * @param seed of what was drawn, the first one where there were several
 * @param duration milliseconds from the beginning to the last frame or event
 * @param counts how often what happened; what never did is not there
 * @param goalReached whether as many cups were delivered as the world wants; false where it wants
 *     none
 * @param stillSince as {@link Recording#stillSince()}
 * @param apart the smallest distance between the bodies of two robots, one of which can drive, in
 *     mm; infinite where there are no two such robots
 * @param clear the smallest distance from the body of a robot that can drive to a wall, to a thing
 *     or to a person's legs, or from its middle to the edge of the floor, in mm: it has fallen when
 *     that is over the edge. Infinite where no robot can drive
 * @param failures why programs stopped, by robot
 * @param late robots whose slices took too long
 */
public record Summary(
        long seed,
        int duration,
        Map<What, Integer> counts,
        boolean goalReached,
        OptionalInt stillSince,
        double apart,
        double clear,
        Map<String, String> failures,
        List<Recording.Late> late) {
    public Summary {
        Map<What, Integer> inOrder = new EnumMap<>(What.class);
        inOrder.putAll(counts);
        counts = Collections.unmodifiableMap(inOrder);
        failures = Collections.unmodifiableMap(new TreeMap<>(failures));
        late = List.copyOf(late);
    }

    /** How often something happened. */
    public int count(What what) {
        return counts.getOrDefault(what, 0);
    }

    /** How often a robot has run into something. */
    public int collisions() {
        return count(What.COLLISION);
    }

    /** Cups that drinkers have taken. */
    public int delivered() {
        return count(What.COFFEE_TAKEN);
    }

    /** Slices of all robots that took too long. */
    public int lateSlices() {
        return late.stream().mapToInt(Recording.Late::slices).sum();
    }
}
