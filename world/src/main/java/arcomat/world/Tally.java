package arcomat.world;

import arcomat.world.Recording.Late;
import arcomat.world.Scene.Happening;
import arcomat.world.Scene.Happening.What;
import arcomat.world.Scene.RobotState;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Keeps of a run what its {@link Summary} says, and nothing else: it does not grow with time. */
public final class Tally {
    private final World world;
    private final long seed;
    private final Clearance clearance;
    private final Map<What, Integer> counts = new EnumMap<>(What.class);
    private final Map<String, String> failures = new TreeMap<>();
    private final Map<String, Late> late = new TreeMap<>();
    private List<RobotState> before = List.of();
    private int moved;
    private int lastFrame;
    private int lastEvent;

    public Tally(World world, long seed) {
        this.world = world;
        this.seed = seed;
        this.clearance = new Clearance(world);
    }

    /** Takes the next scene. */
    public void see(Scene scene) {
        int time = scene.time();
        clearance.measure(scene);
        for (Happening happening : scene.happenings()) {
            counts.merge(happening.what(), 1, Integer::sum);
            lastEvent = time;
        }
        if (time % Recording.PERIOD == 0) {
            lookWhoMoves(scene.robots(), time);
            lastFrame = time;
        }
    }

    /** Looks as seldom as a recording does, to come to the same answer. */
    private void lookWhoMoves(List<RobotState> robots, int time) {
        for (int i = 0; i < before.size(); i++) {
            if (!robots.get(i).pose().equals(before.get(i).pose())) {
                moved = time;
            }
        }
        before = robots;
    }

    /** A robot has sent something, at a moment in milliseconds. */
    public void sent(int time) {
        lastEvent = time;
    }

    /** A slice of a robot took too long: so many microseconds. */
    public void late(String robot, long microseconds) {
        late.merge(robot, new Late(robot, 1, microseconds), Late::and);
    }

    public void failed(String robot, String reason) {
        failures.put(robot, reason);
    }

    public Summary summary() {
        int duration = Math.max(lastFrame, lastEvent);
        int delivered = counts.getOrDefault(What.COFFEE_TAKEN, 0);
        return new Summary(
                seed,
                duration,
                counts,
                world.goal() > 0 && delivered >= world.goal(),
                Recording.stillSince(world, delivered, duration, moved),
                clearance.apart(),
                clearance.clear(),
                failures,
                List.copyOf(late.values()));
    }
}
