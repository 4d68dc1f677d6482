package arcomat.world;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalLong;
import java.util.stream.IntStream;

/** When a run first comes as near to something as levels say. */
public final class Approach {
    private static final long NEVER = -1;

    private final Clearance clearance;
    private final To what;
    private final List<Integer> levels;
    private final long[] ticks;

    /** To what something is near; as in {@link Summary}. */
    public enum To {
        /** One robot to another. */
        ROBOTS,
        /** A robot to a wall, a person or the edge of the floor. */
        REST
    }

    /**
     * @param levels in mm
     */
    public Approach(World world, To what, List<Integer> levels) {
        this.clearance = new Clearance(world);
        this.what = what;
        this.levels = List.copyOf(levels);
        this.ticks = new long[levels.size()];
        Arrays.fill(ticks, NEVER);
    }

    /** Takes the next scene. */
    public void see(Scene scene) {
        clearance.measure(scene);
        double nearest = what == To.ROBOTS ? clearance.apart() : clearance.clear();
        for (int i = 0; i < ticks.length; i++) {
            if (ticks[i] == NEVER && nearest <= levels.get(i)) {
                ticks[i] = scene.tick();
            }
        }
    }

    /** For each level the first step of the world at which it was reached. */
    public List<OptionalLong> ticks() {
        return IntStream.range(0, ticks.length)
                .mapToObj(i -> ticks[i] == NEVER ? OptionalLong.empty() : OptionalLong.of(ticks[i]))
                .toList();
    }
}
